#include "base/quad.hpp"

#include "expressions/evaluator.hpp"

namespace expressions {

using base::Quad;

template <>
Quad number(const std::string& text) {
    return Quad(text);
}

template class Evaluator<Quad>;
template base::Smooth<Quad> smooth(const std::string&, const std::string&);

}  // namespace expressions
