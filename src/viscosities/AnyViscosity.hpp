// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Zero.hpp"
#include "viscosities/ViscosityChoice.hpp"

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

namespace slosh
{

/// Any of them, asked for at each pair: for loops whose speed does not matter.
template <class S>
class AnyViscosity
{
    /// A variant of the types of inLoop<S>(), each once.
    template <class Variant, class... Types>
    struct EachOnce
    {
        using type = Variant;
    };
    template <class... Seen, class First, class... Rest>
    struct EachOnce<std::variant<Seen...>, First, Rest...>
        : std::conditional_t<
              (std::is_same_v<First, Seen> || ...), EachOnce<std::variant<Seen...>, Rest...>,
              EachOnce<std::variant<Seen..., First>, Rest...>>
    {
    };
    template <class... T>
    static EachOnce<std::variant<>, decltype(std::declval<T>().template inLoop<S>(2, 1.0))...>
    formsOf(const std::variant<T...>&);

    using Form = typename decltype(formsOf(std::declval<ViscosityChoice>()))::type;

public:
    AnyViscosity(const ViscosityChoice& choice, int dim, double h)
        : form_(std::visit([&](const auto& type) -> Form { return type.template inLoop<S>(dim, h); }, choice))
    {
    }

    template <class Pair>
    S operator()(const Pair& pair, const S& approach) const
    {
        return ask(pair, approach, std::make_index_sequence<std::variant_size_v<Form>>());
    }

private:
    template <class Pair, std::size_t... k>
    S ask(const Pair& pair, const S& approach, std::index_sequence<k...>) const
    {
        S Pi(0);
        const auto askOne = [&]<class Type>(const Type* form)
        {
            if constexpr (!std::is_same_v<decltype((*form)(pair, approach)), Zero>)
            {
                if (form != nullptr)
                {
                    Pi = (*form)(pair, approach);
                }
            }
        };
        (askOne(std::get_if<k>(&form_)), ...);
        return Pi;
    }

    Form form_;
};

} // namespace slosh
