#include "bodies/body.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "base/number.hpp"

namespace bodies {

template <int dim>
const Side<dim>& side_named(const Body<dim>& body, const std::string& name) {
    const auto side = std::find_if(body.sides.begin(), body.sides.end(),
                                   [&](const Side<dim>& one) { return one.name == name; });
    if (side != body.sides.end() && !is_unnamed(name)) return *side;
    std::string names;
    for (const Side<dim>& one : body.sides)
        if (!is_unnamed(one.name)) names += (names.empty() ? "" : ", ") + one.name;
    throw base::InvalidInput(
        "the body has no side " + base::quoted(name) +
        (names.empty() ? "; name its sides, as by Physical Curve in a drawing" : "; its sides are " + names));
}

template const Side<2>& side_named(const Body<2>&, const std::string&);
template const Side<3>& side_named(const Body<3>&, const std::string&);

}  // namespace bodies
