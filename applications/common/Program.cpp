// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/Program.hpp"

#include "base/CaseError.hpp"
#include "base/threads.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <new>

namespace slosh
{

namespace po = boost::program_options;

Program::Program(std::string name, std::string purpose, std::string example)
{
    usage_.name = std::move(name);
    usage_.purpose = std::move(purpose);
    usage_.example = std::move(example);
    addOption("case", "dir", "case directory; default: the current directory");
    addOption("help", "", "print this help");
    addOption("help-man", "", "print the manual page in roff format");
    addVariable("SLOSH_ETC", "folder searched by #includeEtc; default: share/sloshsph/etc of the installation");
}

void Program::addOption(const std::string& option, const std::string& what, const std::string& description)
{
    usage_.options.push_back({option, what, description});
    if (what.empty())
    {
        options_.add_options()(option.c_str(), description.c_str());
    }
    else
    {
        options_.add_options()(option.c_str(), po::value<std::string>(), description.c_str());
    }
}

void Program::addThreads()
{
    addOption("threads", "n", "number of threads; default: all processors, or OMP_NUM_THREADS");
    addVariable("OMP_NUM_THREADS", "number of threads if -threads is not given");
}

void Program::addFile(const std::string& file, const std::string& description)
{
    usage_.files.push_back({file, "", description});
}

void Program::addVariable(const std::string& variable, const std::string& description)
{
    usage_.variables.push_back({variable, "", description});
}

void Program::addDictionary(const AnnotatedDictionary& dictionary)
{
    if (usage_.dictionaries.empty())
    {
        addOption("help-dict", "file", "print a dictionary with every entry, its unit and default, as a template");
    }
    usage_.dictionaries.push_back(dictionary);
}

std::string Program::version()
{
    return SLOSH_VERSION;
}

void Program::printBanner(int argc, char** argv) const
{
    const int threads = slosh::threads(); // or an error, before anything is printed
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    std::cout << "/*---------------------------------------------------------------------------*\\\n"
              << "| SloshSPH " << SLOSH_VERSION
              << ": smoothed particle hydrodynamics of liquid sloshing in moving tanks\n"
              << "\\*---------------------------------------------------------------------------*/\n"
              << "Exec   :";
    for (int k = 0; k < argc; ++k)
    {
        std::cout << " " << (k == 0 ? usage_.name : argv[k]);
    }
    std::cout << "\nDate   : " << std::put_time(&local, "%b %d %Y")
              << "\nTime   : " << std::put_time(&local, "%H:%M:%S") << "\nCase   : " << caseFolder()
              << "\nThreads: " << threads << "\n\n";
}

void Program::parse(int argc, char** argv)
{
    const auto invalid = [&](const std::string& what)
    { return CaseError(what + "\nSee '" + usage_.name + " -help' for usage"); };
    try
    {
        const auto style = po::command_line_style::allow_long | po::command_line_style::allow_long_disguise |
                           po::command_line_style::long_allow_next;
        const auto parsed = po::command_line_parser(argc, argv).options(options_).style(style).positional({}).run();
        po::store(parsed, values_);
    }
    catch (const po::too_many_positional_options_error&)
    {
        // To the library an unknown option with one dash is no option at all.
        std::vector<std::string> valid;
        for (const auto& option : usage_.options)
        {
            valid.push_back("-" + option.name);
        }
        for (int k = 1; k < argc; ++k)
        {
            const std::string given = argv[k];
            if (given[0] == '-' && std::find(valid.begin(), valid.end(), given) == valid.end())
            {
                if (given == "-parallel")
                {
                    throw invalid("Invalid option: -parallel; programs run on threads of one machine, -threads <n>");
                }
                const std::string nearest = nearestName(given, valid);
                throw invalid("Invalid option: " + given + (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
            }
        }
        throw invalid("Invalid argument: " + usage_.name + " takes options only");
    }
    catch (const po::error& error)
    {
        throw invalid(std::string("Invalid option: ") + error.what());
    }
    if (has("threads"))
    {
        setThreads(numberOfThreads("-threads", value("threads")));
    }
}

int Program::run(int argc, char** argv, const std::function<void()>& work)
{
    try
    {
        parse(argc, argv);
        if (has("help-man"))
        {
            std::cout << usage_.manPage();
        }
        else if (has("help-dict"))
        {
            std::cout << usage_.annotated(value("help-dict"));
        }
        else if (has("help"))
        {
            std::cout << usage_.help();
        }
        else
        {
            printBanner(argc, argv);
            work();
            std::cout << "\nEnd\n";
        }
        std::cout << std::flush;
        if (!std::cout)
        {
            std::cerr << "--> FOAM FATAL ERROR:\ncannot write to standard output\n";
            return 1;
        }
        return 0;
    }
    catch (const CaseError& error)
    {
        std::cout << std::flush;
        std::cerr << "\n" << error.text() << std::flush;
    }
    catch (const std::bad_alloc&)
    {
        std::cout << std::flush;
        std::cerr << "\n--> FOAM FATAL ERROR:\nnot enough memory for this case\n" << std::flush;
    }
    catch (const std::exception& error)
    {
        std::cout << std::flush;
        std::cerr << "\n--> FOAM FATAL ERROR:\nunexpected: " << error.what() << "\n" << std::flush;
    }
    return 1;
}

} // namespace slosh
