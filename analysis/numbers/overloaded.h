// A visitor of a variant, made of one function for each alternative.

#pragma once

namespace asperity {

/// `std::visit(Overloaded{[](const A&) { … }, [](const B&) { … }}, value)`.
template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace asperity
