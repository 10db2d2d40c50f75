// Formulas (formula.hpp), parsed and evaluated by muParser.
#pragma once

#include "core/base/points.hpp"
#include "core/function/formula.hpp"
#include "core/mesh/space.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gaspard {

/// A parsed formula.
class Expression {
  public:
    /// Throws ExpressionError if the text is not a formula in the coordinates of the space.
    Expression(std::string text, Space space);

    const std::string& text() const { return text_; }
    const Space& space() const { return space_; }
    /// The names of the parameters, in order of appearance.
    const std::vector<std::string>& parameters() const { return parameters_; }
    /// Whether the value depends on these coordinates: x and y, z, u and v.
    bool uses_plane() const { return uses_plane_; }
    bool uses_z() const { return uses_z_; }
    bool uses_parameters() const { return uses_parameters_; }

  private:
    std::string text_;
    Space space_;
    std::vector<std::string> parameters_;
    bool uses_plane_ = false, uses_z_ = false, uses_parameters_ = false;
};

/// A formula with values for its parameters, as a function of the position.
class ExpressionFunction {
  public:
    /// `parameters`: in the order of Expression::parameters().
    ExpressionFunction(Expression expression, std::span<const double> parameters);
    ~ExpressionFunction();
    ExpressionFunction(ExpressionFunction&&) noexcept;
    ExpressionFunction& operator=(ExpressionFunction&&) noexcept;

    const Expression& expression() const { return expression_; }
    /// f at every point, which may be infinite or not a number. Coordinates are taken as they are; on a
    /// sphere only the direction of a point matters. `uv`: the parameters of the points, empty unless the
    /// formula uses them. `values`: x.size() entries. May be called from several threads at once.
    void values(const Points& x, const Points& uv, std::span<double> values) const;

  private:
    struct Evaluators;
    Expression expression_;
    std::unique_ptr<Evaluators> evaluators_;
};

} // namespace gaspard
