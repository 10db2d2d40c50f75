#include "core/function/coefficient.hpp"

#include "core/base/join.hpp"
#include "core/base/short_number.hpp"
#include "core/function/expression.hpp"
#include "core/function/source.hpp"

#include <cmath>
#include <memory>
#include <vector>

namespace gaspard {

static Expression parse(const Values& values, const std::string& key, const Space& space) {
    try {
        return Expression(values.text(key), space);
    } catch (const ExpressionError& error) {
        throw InputError(key_name(values, key) + ": " + error.what());
    }
}

/// " at x = 0.5" or " at (0.5, 1)".
static std::string place(const Points& x, std::size_t i, int dimension) {
    return dimension == 1 ? " at x = " + exact_number(x.x[i])
                          : " at (" + exact_number(x.x[i]) + ", " + exact_number(x.y[i]) + ")";
}

Coefficient coefficient(const Values& values, const std::string& key, int dimension,
                        const std::map<std::string, double>& names) {
    const Expression expression = parse(values, key, {.dimension = dimension});
    std::vector<double> parameters;
    for (const std::string& name : expression.parameters()) {
        const auto found = names.find(name);
        if (found == names.end()) {
            std::vector<std::string> known = {"x"};
            if (dimension > 1) known.emplace_back("y");
            for (const auto& one : names) known.push_back(one.first);
            throw InputError(key_name(values, key) + ": unknown name '" + name + "'" +
                             did_you_mean(name, known) + "; known: " + join(known, ", "));
        }
        parameters.push_back(found->second);
    }
    auto function = std::make_shared<const ExpressionFunction>(expression, parameters);
    return [function, name = key_name(values, key), dimension](const Points& x, std::span<double> out) {
        function->values(x, {}, out);
        for (std::size_t i = 0; i < out.size(); ++i)
            if (!std::isfinite(out[i])) throw InputError(name + " is not finite" + place(x, i, dimension));
    };
}

Coefficient coefficient_from_zero(const Values& values, const std::string& key, int dimension,
                                  const std::map<std::string, double>& names) {
    constexpr double rounding = 1e-12; // sin(pi*x) at 1
    return [any = coefficient(values, key, dimension, names), name = key_name(values, key),
            dimension](const Points& x, std::span<double> out) {
        any(x, out);
        for (std::size_t i = 0; i < out.size(); ++i)
            if (out[i] < -rounding)
                throw InputError(name + " is " + exact_number(out[i]) + place(x, i, dimension) +
                                 "; it must not be negative");
    };
}

ParameterRow coefficient_row(const char* key, const char* label, const char* symbol, const char* formula,
                             const char* help) {
    return {.key = key,
            .label = label,
            .symbol = symbol,
            .kind = ParameterKind::text,
            .default_value = std::string(formula),
            .help = help};
}

} // namespace gaspard
