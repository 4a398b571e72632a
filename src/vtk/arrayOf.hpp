// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Vec.hpp"

#include <vtkNew.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace slosh
{

/// values[first], ..., values[first + n - 1] as a VTK array with the components of one value.
template <class Array, class T>
vtkNew<Array> arrayOf(const std::string& name, const std::vector<T>& values, std::ptrdiff_t first, std::ptrdiff_t n)
{
    vtkNew<Array> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(std::is_same_v<T, Vec> ? 3 : 1);
    array->SetNumberOfTuples(n);
    for (std::ptrdiff_t i = 0; i < n; ++i)
    {
        const T& value = values[first + i];
        if constexpr (std::is_same_v<T, Vec>)
        {
            array->SetTuple3(i, value.x(), value.y(), value.z());
        }
        else
        {
            array->SetValue(i, value);
        }
    }
    return array;
}

/// All of them.
template <class Array, class T>
vtkNew<Array> arrayOf(const std::string& name, const std::vector<T>& values)
{
    return arrayOf<Array>(name, values, 0, static_cast<std::ptrdiff_t>(values.size()));
}

} // namespace slosh
