// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/derivedField.hpp"

#include "base/CaseError.hpp"
#include "sampling/vorticity.hpp"

namespace slosh
{

const std::vector<DerivedField>& derivedFields()
{
    static const std::vector<DerivedField> table = {
        {"vorticity", "curl of the liquid's velocity, [1/s]", vorticity},
    };
    return table;
}

Field derivedField(
    const std::string& name, const Particles& particles, const Scene& scene, const std::vector<std::string>& others
)
{
    std::vector<std::string> valid = others;
    for (const DerivedField& field : derivedFields())
    {
        if (field.name == name)
        {
            return field.read(particles, scene);
        }
        valid.emplace_back(field.name);
    }
    throw unknownName("field", name, "-fields", valid);
}

} // namespace slosh
