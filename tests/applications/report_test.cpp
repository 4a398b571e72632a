// SPDX-License-Identifier: GPL-3.0-or-later
// sloshReport, as users start it on a case: one page that needs nothing beside it.
#include "CaseDirectory.hpp"
#include "htmlPage.hpp"
#include "installed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace slosh
{
namespace
{

namespace fs = std::filesystem;

/// A case with particles at time 0 and 25.6 s of two pressures: a sine of 4 rad/s about 1 kPa, and a dry probe.
class Report : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!isInstalled("gnuplot"))
        {
            GTEST_SKIP() << "gnuplot is not installed";
        }
        case_.succeed("blockParticles");
    }

    void addSamples() const
    {
        std::ostringstream text;
        text << "# Probe 0 (0 -0.1 0.05)\n# Probe 1 (0 0.1 0.14)\n#       Probe             0             1\n"
             << "#        Time\n"
             << std::setprecision(10);
        for (int k = 0; k < 512; ++k)
        {
            text << 0.05 * k << " " << 1000 + 300 * std::sin(4 * 0.05 * k) << " 0\n";
        }
        case_.write("postProcessing/pressure/0/p", text.str());
    }

    std::string page(const std::string& options = "") const
    {
        const std::string said = case_.succeed("sloshReport " + options);
        EXPECT_NE(said.find("Wrote postProcessing/report.html\n"), std::string::npos) << said;
        return case_.text("postProcessing/report.html");
    }

    void expectRefused(const std::string& options, const std::string& words, const std::string& before = "") const
    {
        const auto tree = case_.tree();
        const Ended ended = case_.run("sloshReport " + options, before);
        EXPECT_EQ(ended.status, 1) << options;
        EXPECT_NE(ended.err.find("--> FOAM FATAL"), std::string::npos) << ended.err;
        EXPECT_NE(ended.err.find(words), std::string::npos) << ended.err;
        EXPECT_EQ(case_.tree(), tree) << "left behind by " << options;
    }

    const CaseDirectory case_;
};

/// A section, from its heading to the next.
std::string sectionOf(const std::string& page, const std::string& id)
{
    const auto at = page.find("<h2 id=\"" + id + "\">");
    EXPECT_NE(at, std::string::npos) << id;
    return at == std::string::npos ? "" : page.substr(at, page.find("<h2 ", at + 1) - at);
}

TEST_F(Report, IsOneWellFormedPageWithEverySectionThatNamesNothingOutside)
{
    addSamples();
    const std::string text = page();
    EXPECT_EQ(faultOf(text), "");
    EXPECT_EQ(text.find("http"), std::string::npos);
    EXPECT_EQ(text.find("<script"), std::string::npos);
    EXPECT_EQ(text.find("url("), std::string::npos);
    int links = 0;
    for (auto at = text.find('='); at != std::string::npos; at = text.find('=', at + 1))
    {
        const std::string before = text.substr(at - 4, 4), after = text.substr(at + 1, 12);
        if (before == "href" || before.substr(1) == "src")
        {
            ++links;
            EXPECT_TRUE(after.rfind("\"#", 0) == 0 || after.rfind("\"data:image/", 0) == 0) << after;
        }
    }
    EXPECT_EQ(links, 9 + 3); // sections; a snapshot, a history, a spectrum
    const auto pictures = picturesIn(text);
    ASSERT_EQ(pictures.size(), 3u);
    EXPECT_EQ(pictures[0].substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(pictures[0].substr(pictures[0].size() - 8, 4), "IEND");
    for (const std::size_t k : {1u, 2u})
    {
        EXPECT_NE(pictures[k].find("<svg"), std::string::npos);
        EXPECT_EQ(pictures[k].substr(pictures[k].rfind('<'), 6), "</svg>");
        EXPECT_NE(pictures[k].find("p0 (0 -0.1 0.05)"), std::string::npos);
    }
    EXPECT_EQ(case_.text("postProcessing/report.html"), page()) << "twice the same";
}

TEST_F(Report, SaysWhatTheCaseIsAndItsFrequencies)
{
    addSamples();
    case_.edit("constant/dynamicMeshDict", "omega 8;", "omega 4;");
    const std::string text = page();
    const std::string setUp = sectionOf(text, "setUp");
    for (const std::string words :
         {"2D: 0.2 m in y x 0.15 m in z, a slice 1 m thick", "0.1 m deep, 66.7 % of the height; 0.02 m^3", "20 kg",
          "amplitude (8 0 0) deg, omega 4 rad/s", "200 of liquid", "0.01 m apart: 10 over the depth",
          "improvedGaussian, h = 0.0123 m = 1.23 spacings", "artificial, alpha = 0.03", "predictorCorrector"})
    {
        EXPECT_NE(setUp.find(words), std::string::npos) << words << "\n" << setUp;
    }
    const std::string frequencies = sectionOf(text, "frequencies");
    const double k = std::acos(-1.0) / 0.2, omega = std::sqrt(9.81 * k * std::tanh(k * 0.1));
    std::ostringstream first;
    first << std::setprecision(4) << "omega1, linear theory</td><td class=\"n\">" << omega;
    EXPECT_NE(frequencies.find(first.str()), std::string::npos) << frequencies;
    EXPECT_NE(frequencies.find("dominant frequency of its acceleration</td><td class=\"n\">4<"), std::string::npos)
        << frequencies;
    const std::string spectrum = picturesIn(text).back();
    for (const std::string mark : {"ω1", "ω2", "ω3", "motion", "angular frequency [rad/s]"})
    {
        EXPECT_NE(spectrum.find(mark), std::string::npos) << mark;
    }
}

TEST_F(Report, LeavesOutWhatIsBeforeATimeOnRequestAndShowsTheTimesThatAreAskedFor)
{
    addSamples();
    EXPECT_NE(picturesIn(page())[1].find(" 5<"), std::string::npos);
    const std::string later = page("-from 20 -time 0");
    EXPECT_EQ(picturesIn(later)[1].find(" 5<"), std::string::npos) << "the axis begins at 0";
    EXPECT_NE(later.find("<figcaption>t = 0 s</figcaption>"), std::string::npos);
    expectRefused("-from soon", "-from is soon; expected a time [s]");
    expectRefused("-from 99", "-from is 99; expected a time before the last one, 25.55 s");
    expectRefused("-time 7:9", "time");
}

TEST_F(Report, KeepsTheHighestAndTheLowestOfVeryManySamplesInASmallPicture)
{
    std::ostringstream text;
    text << "#        Time       outside\n";
    for (int k = 0; k < 20000; ++k)
    {
        text << k << " " << (k == 7777 ? 1900 : k == 7779 ? -900 : k % 7) << "\n";
    }
    case_.write("postProcessing/particlesOutside/0/particlesOutside.dat", text.str());
    const std::string picture = picturesIn(page())[1];
    EXPECT_NE(picture.find(" 2000<"), std::string::npos) << "the highest";
    EXPECT_NE(picture.find("-1000<"), std::string::npos) << "the lowest";
    EXPECT_LT(picture.size(), 60000u);
}

TEST_F(Report, LeavesTheCasesOfSweepsAndStudiesToThem)
{
    addSamples();
    const std::string alone = page();
    for (const std::string folder : {"sweep", "workPrecision"})
    {
        case_.write(
            "postProcessing/" + folder + "/0/runs/one/postProcessing/pressure/0/p",
            case_.text("postProcessing/pressure/0/p")
        );
    }
    EXPECT_EQ(picturesIn(page()).size(), picturesIn(alone).size());
}

TEST_F(Report, OfARunThatIsShortAgainstTheNaturalPeriodsHasItsSpectra)
{
    std::ostringstream text;
    text << "# Probe 0 (0 -0.1 0.05)\n#       Probe             0\n#        Time\n";
    for (int k = 0; k < 64; ++k)
    {
        text << 0.0005 * k << " " << 1000 + 300 * std::sin(2000 * 0.0005 * k) << "\n";
    }
    case_.write("postProcessing/pressure/0/p", text.str());
    EXPECT_NE(page().find("Power spectral densities"), std::string::npos);
}

TEST_F(Report, JoinsTheSamplesOfARunThatWentOnAndSaysWhereTheyDoNotFit)
{
    addSamples();
    const std::string all = case_.text("postProcessing/pressure/0/p"), head = all.substr(0, all.find("0 1000"));
    case_.write("postProcessing/pressure/20/p", head + "20.5 1000 0\n29.9 1100 0\n");
    const std::string joined = page();
    EXPECT_NE(picturesIn(joined)[1].find(" 5<"), std::string::npos);
    EXPECT_NE(picturesIn(joined)[1].find(" 30<"), std::string::npos);
    EXPECT_EQ(joined.find("are omitted</figcaption>"), std::string::npos);
    // One probe since then.
    case_.write("postProcessing/pressure/29.9/p", "# Probe 0 (0 -0.1 0.05)\n#  Probe  0\n# Time\n30 1000\n40 1100\n");
    const std::string apart = page();
    EXPECT_EQ(picturesIn(apart)[1].find(" 5<"), std::string::npos);
    EXPECT_NE(apart.find("samples with other columns before a restart are omitted</figcaption>"), std::string::npos);
}

TEST_F(Report, SaysInASentenceWhatIsNotThere)
{
    const std::string text = page();
    EXPECT_EQ(faultOf(text), "");
    for (const auto& [section, words] : std::vector<std::pair<std::string, std::string>>{
             {"histories", "No samples: no function"},
             {"spectra", "There is no varying series of 16 samples"},
             {"comparisons", "compareSamples makes those set in system/comparisonsDict"},
             {"peaks", "peakStatistics evaluates those set in"},
             {"errors", "workPrecision runs those set in"},
             {"timing", "There is no log.sloshSPHFoam in the case"}})
    {
        EXPECT_NE(sectionOf(text, section).find(words), std::string::npos) << section;
    }
}

TEST_F(Report, HoldsWhatTheOtherProgramsHaveMade)
{
    addSamples();
    case_.write(
        "system/peakStatisticsDict", "crests { samples \"pressure/p\"; column 1; threshold 1200; separation 1; }\n"
    );
    case_.write(
        "system/comparisonsDict",
        "crest { description \"highest & dearest\"; samples \"pressure/p\"; column 1; unit Pa; quantity "
        "maximum; reference { type stated; value 1300; source \"<us>\"; } }\n"
    );
    case_.succeed("peakStatistics");
    case_.succeed("compareSamples");
    case_.write("postProcessing/workPrecision/0/summary.txt", "2 % needs dx < 0.05 m\n");
    case_.edit("system/controlDict", "endTime 0.1;", "endTime 0.02;");
    case_.write("log.sloshSPHFoam", case_.succeed("sloshSPHFoam -threads 1"));
    const std::string text = page();
    EXPECT_EQ(faultOf(text), "");
    EXPECT_NE(sectionOf(text, "peaks").find("<td>count</td><td>16<"), std::string::npos)
        << sectionOf(text, "peaks"); // crests at (pi/2 + 2 pi k)/4 < 25.6 s
    EXPECT_NE(sectionOf(text, "comparisons").find("<td>highest &amp; dearest</td><td>1300"), std::string::npos);
    EXPECT_NE(sectionOf(text, "comparisons").find("<td>&lt;us&gt;</td>"), std::string::npos);
    EXPECT_NE(sectionOf(text, "errors").find("2 % needs dx &lt; 0.05 m"), std::string::npos);
    for (const std::string words : {"right-hand sides</td>", "Steps</th>", "Wall-clock time</th>", "Memory of"})
    {
        EXPECT_NE(sectionOf(text, "timing").find(words), std::string::npos) << words;
    }
    EXPECT_EQ(sectionOf(text, "timing").find("has not finished"), std::string::npos);
    EXPECT_NE(sectionOf(text, "setUp").find("omitted: the empty direction"), std::string::npos);

    const std::string log = case_.text("log.sloshSPHFoam");
    case_.write("log.sloshSPHFoam", log.substr(0, log.find("Steps: ")));
    EXPECT_NE(sectionOf(page(), "timing").find("has not finished"), std::string::npos);
}

TEST_F(Report, OfACaseOfAnyNameIsTheSame)
{
    addSamples();
    const std::string here = page();
    case_.write("script", R"(
mkdir 'R & D "<1>"' && cp -r 0 constant system postProcessing 'R & D "<1>"'
')" SLOSH_BIN R"(/sloshReport' -case 'R & D "<1>"' -output 'to "<&>".html' && mv to* page.html
)");
    const Ended ended = case_.run("./script", "bash");
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("Wrote to \"<&>\".html\n"), std::string::npos) << ended.out;
    std::string there = case_.text("page.html");
    const std::string name = case_.path().filename().string(), theirs = "R &amp; D &quot;&lt;1&gt;&quot;";
    EXPECT_NE(there.find("<h1>" + theirs + "</h1>"), std::string::npos);
    for (auto at = there.find(theirs); at != std::string::npos; at = there.find(theirs))
    {
        there.replace(at, theirs.size(), name);
    }
    EXPECT_EQ(there, here);
}

TEST_F(Report, IsRefusedWithAWordWhereThereIsNothingToReportAndLeavesNothingBehind)
{
    expectRefused("-case absent", "cannot open case directory");
    expectRefused("-log log.other", "cannot read the log");
    case_.write("log.blockParticles", case_.succeed("blockParticles"));
    expectRefused("-log log.blockParticles", "not a log of sloshSPHFoam");
    expectRefused("-output absent/sub/page.html -form 3", "did you mean -from?");
    expectRefused("", "gnuplot not found", "env PATH=/absent");
    case_.edit("constant/kernelProperties", "improvedGaussian", "gaussian");
    expectRefused("", "unknown kernel type 'gaussian'");
    case_.edit("constant/kernelProperties", "gaussian", "improvedGaussian");
    case_.remove("0");
    expectRefused("", "no time directories and no samples found");
}

TEST_F(Report, IsShownByABrowserOnAPhoneAndOnAScreen)
{
    if (!isInstalled("chromium"))
    {
        GTEST_SKIP() << "NOT TESTED: chromium is not installed (etc/install-dependencies test)";
    }
    addSamples();
    // Each width in a frame of its own, whose page tells what it sees.
    const std::string probe = R"(<script>
window.onload = () => {
    const images = [...document.images];
    const text = [innerWidth, images.length, images.filter(i => !(i.complete && i.naturalWidth > 99)).length,
                  document.documentElement.scrollWidth - innerWidth,
                  performance.getEntriesByType('resource').filter(r => !r.name.startsWith('data:')).length,
                  [...document.querySelectorAll('h2')].filter(h => h.offsetHeight > 0).length,
                  document.compatMode].join(' ');
    parent.document.body.insertAdjacentHTML('beforeend', '<p>seen ' + text + '</p>');
};
</script></body>)";
    std::string inner = page();
    inner.replace(inner.find("</body>"), 7, probe);
    std::string quoted;
    for (const char c : inner)
    {
        quoted += c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    std::string outer = "<!DOCTYPE html><title>frames</title><body>";
    for (const std::string width : {"400", "1200"})
    {
        outer +=
            "<iframe style=\"border:0\" width=\"" + width + "\" height=\"800\" srcdoc=\"" + quoted + "\"></iframe>";
    }
    case_.write("frames.html", outer + "</body>");
    case_.write(
        "script", "HOME=$PWD exec chromium --headless --no-sandbox --disable-gpu --hide-scrollbars "
                  "--user-data-dir=\"$PWD/profile\" --enable-logging=stderr --dump-dom \"file://$PWD/frames.html\""
    );
    const Ended ended = case_.run("./script", "bash");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(ended.err.find("CONSOLE"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("<p>seen 400 3 0 0 0 9 CSS1Compat</p>"), std::string::npos)
        << ended.out.substr(ended.out.size() - 300);
    EXPECT_NE(ended.out.find("<p>seen 1200 3 0 0 0 9 CSS1Compat</p>"), std::string::npos)
        << ended.out.substr(ended.out.size() - 300);
}

} // namespace
} // namespace slosh
