// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/Usage.hpp"

#include "dictionary/Choice.hpp"

#include <boost/program_options.hpp>

#include <functional>
#include <string>

namespace slosh
{

/// The command line of a program, with OpenFOAM's habits: options with one dash, -case, -help and -help-man everywhere.
class Program
{
public:
    /// `purpose`: one line; `example`: a command line for -help.
    Program(std::string name, std::string purpose, std::string example);

    /// An option with an argument (shown as <what>) or, where `what` is empty, without. The completion knows the
    /// arguments dir, file (of the case), ranges (of times), n, and words given as "vtu|csv".
    void addOption(const std::string& option, const std::string& what, const std::string& description);
    /// -threads <n>, for programs that compute.
    void addThreads();
    /// For -help and the manual page: a file of the case that is read or written, an environment variable that is
    /// heeded.
    void addFile(const std::string& file, const std::string& description);
    void addVariable(const std::string& variable, const std::string& description);
    /// A dictionary that it reads, for -help-dict and the manual page.
    void addDictionary(const AnnotatedDictionary& dictionary);
    /// Likewise: what an entry, "kernel in constant/kernelProperties", can name.
    template <class Read>
    void addChoices(const std::string& entry, const std::vector<Choice<Read>>& table)
    {
        auto& names = usage_.choices.emplace_back(Usage::Choices{entry, {}}).names;
        for (const auto& choice : table)
        {
            names.push_back({std::string(choice.name), "", std::string(choice.sentence)});
        }
    }

    /// Parses, prints the banner, calls `work` and ends with "End". Returns the exit status: 0; 1 after a CaseError or
    /// any other exception, told on stderr; 0 after -help and -help-man.
    int run(int argc, char** argv, const std::function<void()>& work);

    // While `work` runs:
    bool has(const std::string& option) const { return values_.count(option) != 0; }
    std::string value(const std::string& option) const { return values_[option].as<std::string>(); }
    static std::string version(); ///< of the suite, "0.1.0"
    std::string caseFolder() const { return has("case") ? value("case") : "."; }

private:
    void parse(int argc, char** argv);
    void printBanner(int argc, char** argv) const;

    Usage usage_;
    boost::program_options::options_description options_;
    boost::program_options::variables_map values_;
};

} // namespace slosh
