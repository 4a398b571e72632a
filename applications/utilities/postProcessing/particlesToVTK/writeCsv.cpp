// SPDX-License-Identifier: GPL-3.0-or-later
#include "writeCsv.hpp"

#include "base/writeFile.hpp"

#include <functional>
#include <iomanip>
#include <sstream>
#include <type_traits>

namespace slosh
{

namespace
{

template <class T>
void append(std::ostream& out, const T& value)
{
    if constexpr (std::is_same_v<T, Vec>)
    {
        out << value.x() << ',' << value.y() << ',' << value.z();
    }
    else
    {
        out << value;
    }
}

} // namespace

void writeCsv(
    const std::filesystem::path& file, const Particles& particles, ParticleRange range,
    const std::vector<std::string>& fields
)
{
    const std::ptrdiff_t first = particles.first(range), n = particles.size(range);
    std::ostringstream text;
    text << std::setprecision(9) << "x,y,z";
    std::vector<std::function<void(std::ptrdiff_t)>> columns = {[&](std::ptrdiff_t i)
                                                                { append(text, particles.r[first + i]); }};
    for (const std::string& field : fields)
    {
        particles.forEachField(
            [&](const std::string& name, ParticleRange has, const auto& values)
            {
                if (name != field || (has != ParticleRange::all && has != range))
                {
                    return;
                }
                constexpr bool isVector = std::is_same_v<std::decay_t<decltype(values[0])>, Vec>;
                text << ',' << (isVector ? field + "_x," + field + "_y," + field + "_z" : field);
                columns.emplace_back(
                    [&text, &values, from = first - particles.first(has)](std::ptrdiff_t i)
                    {
                        text << ',';
                        append(text, values[from + i]);
                    }
                );
            }
        );
    }
    text << '\n';
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        for (const auto& column : columns)
        {
            column(i);
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
        append(text, outline.corners[from]);
        text << '\n';
        append(text, outline.corners[to]);
        text << "\n\n";
    }
    writeFile(file, text.str());
}

} // namespace slosh
