// SPDX-License-Identifier: GPL-3.0-or-later
#include "writeCsv.hpp"

#include "base/writeFile.hpp"

#include <iomanip>
#include <sstream>

namespace slosh
{

namespace
{

std::ostream& operator<<(std::ostream& out, const Vec& value)
{
    return out << value.x() << ',' << value.y() << ',' << value.z();
}

} // namespace

void writeCsv(const std::filesystem::path& file, const Particles& particles, std::ptrdiff_t first, std::ptrdiff_t n,
              const std::vector<std::string>& fields, const DerivedFields& derived)
{
    const auto isVector = [&](const std::string& field) { return field == "U" || derived.count(field) > 0; };
    std::ostringstream text;
    text << std::setprecision(9) << "x,y,z";
    for (const std::string& field : fields)
    {
        text << ',' << (isVector(field) ? field + "_x," + field + "_y," + field + "_z" : field);
    }
    text << '\n';
    for (std::ptrdiff_t i = first; i < first + n; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        text << particles.r[k];
        for (const std::string& field : fields)
        {
            text << ',';
            if (field == "U")
            {
                text << particles.v[k];
            }
            else if (field == "p")
            {
                text << particles.p[k];
            }
            else if (field == "rho")
            {
                text << particles.rho[k];
            }
            else if (const auto values = derived.find(field); values != derived.end())
            {
                text << values->second[k];
            }
            else
            {
                text << particles.id[k];
            }
        }
        text << '\n';
    }
    writeFile(file, text.str());
}

void writeCsv(const std::filesystem::path& file, const TankOutline& outline)
{
    std::ostringstream text;
    text << std::setprecision(9) << "x,y,z\n";
    for (const auto& [from, to] : outline.edges)
    {
        text << outline.corners[from] << '\n' << outline.corners[to] << "\n\n";
    }
    writeFile(file, text.str());
}

} // namespace slosh
