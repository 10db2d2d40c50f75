#include "core/monitor/combine.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// The terms t_i of one point become m, and the weights dm / dlog t_i of their gradients.
class Operation {
  public:
    explicit Operation(const CombineOptions& options) : options_(options) {}

    double value(std::span<const double> terms) const {
        const bool least = options_.operation == CombineOperation::minimum;
        if (options_.operation == CombineOperation::sum) {
            double sum = 0;
            for (const double term : terms) sum += term;
            return sum;
        }
        if (options_.operation == CombineOperation::product) {
            double product = 1;
            for (const double term : terms) product *= term;
            return product;
        }
        const double extreme = least ? *std::min_element(terms.begin(), terms.end())
                                     : *std::max_element(terms.begin(), terms.end());
        if (!options_.sharpness) return extreme;
        const double s = least ? -*options_.sharpness : *options_.sharpness;
        double sum = 0; // of powers of ratios, which neither overflow nor all underflow
        for (const double term : terms) sum += std::pow(term / extreme, s);
        return extreme * std::pow(sum, 1 / s);
    }
    /// dm/dt_i t_i, for m = value(terms).
    void shares(std::span<const double> terms, double m, std::span<double> shares) const {
        if (options_.operation == CombineOperation::sum)
            std::copy(terms.begin(), terms.end(), shares.begin());
        else if (options_.operation == CombineOperation::product)
            std::fill(shares.begin(), shares.end(), m);
        else
            for (std::size_t i = 0; i < terms.size(); ++i) shares[i] = share(terms[i], m);
        if (options_.sharpness || !is_extreme()) return;
        bool taken = false; // of equal terms the first
        for (double& share : shares) share = std::exchange(taken, taken || share > 0) ? 0 : share;
    }

  private:
    bool is_extreme() const {
        return options_.operation == CombineOperation::maximum ||
               options_.operation == CombineOperation::minimum;
    }
    double share(double term, double m) const {
        if (!options_.sharpness) return term == m ? m : 0;
        const double s = *options_.sharpness;
        return m * std::pow(term / m, options_.operation == CombineOperation::minimum ? -s : s);
    }

    CombineOptions options_;
};

class CombinedMonitor final : public Monitor {
  public:
    CombinedMonitor(std::vector<CombinedPart> parts, const CombineOptions& options)
        : parts_(std::move(parts)), operation_(options) {}

    void values(const Points& x, std::span<double> values) const override {
        GASPARD_CHECK(values.size() == x.size());
        const auto terms = terms_at(x);
        std::vector<double> here(parts_.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t k = 0; k < here.size(); ++k) here[k] = terms[k][i];
            values[i] = operation_.value(here);
        }
    }

    /// grad m = sum over i of dm/dt_i t_i p_i grad m_i / m_i
    void gradients(const Points& x, Points& gradients) const override {
        std::vector<std::vector<double>> ms(parts_.size()), terms(parts_.size());
        std::vector<Points> slopes(parts_.size());
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            parts_[k].monitor->gradients(x, slopes[k]);
            if (slopes[k].size() != x.size()) return gradients.resize(0); // a caller's: differences of m
            ms[k].resize(x.size());
            parts_[k].monitor->values(x, ms[k]);
            terms[k] = ms[k];
            raise(parts_[k], terms[k]);
        }
        gradients = Points(x.size());
        std::vector<double> here(parts_.size()), shares(parts_.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t k = 0; k < here.size(); ++k) here[k] = terms[k][i];
            operation_.shares(here, operation_.value(here), shares);
            Vec3 sum;
            for (std::size_t k = 0; k < here.size(); ++k)
                if (shares[k] != 0) sum = sum + (shares[k] * parts_[k].power / ms[k][i]) * slopes[k][i];
            gradients.set(i, sum);
        }
    }

    void check() const override {
        for (const CombinedPart& part : parts_) part.monitor->check();
    }

    std::optional<SpaceKind> made_for() const override {
        for (const CombinedPart& part : parts_)
            if (const auto kind = part.monitor->made_for()) return kind;
        return std::nullopt;
    }

    MonitorReport report() const override {
        MonitorReport whole;
        for (const CombinedPart& part : parts_) {
            const MonitorReport own = part.monitor->report();
            const std::string prefix = part.name.empty() ? "" : "Part " + part.name + ": ";
            for (const std::string& note : own.notes) whole.notes.push_back(prefix + note);
            if (whole.advice.empty()) whole.advice = own.advice;
            for (const auto& [key, choices] : own.choices) whole.choices[part.name + "." + key] = choices;
        }
        return whole;
    }

    std::vector<Field> fields(const Points& x) const override {
        std::vector<Field> fields;
        for (const CombinedPart& part : parts_) {
            if (part.name.empty()) continue;
            Field field;
            field.name = "part-" + part.name;
            field.label = "part " + part.name;
            field.symbol = "m_" + part.name;
            field.values.resize(x.size());
            part.monitor->values(x, field.values);
            fields.push_back(std::move(field));
        }
        return fields;
    }

  private:
    static void raise(const CombinedPart& part, std::span<double> values) {
        for (double& value : values)
            value = part.weight * (part.power == 1 ? value : std::pow(value, part.power));
    }
    std::vector<std::vector<double>> terms_at(const Points& x) const {
        std::vector<std::vector<double>> terms(parts_.size(), std::vector<double>(x.size()));
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            parts_[k].monitor->values(x, terms[k]);
            raise(parts_[k], terms[k]);
        }
        return terms;
    }

    std::vector<CombinedPart> parts_;
    Operation operation_;
};

} // namespace

std::shared_ptr<const Monitor> combined_monitor(std::vector<CombinedPart> parts,
                                                const CombineOptions& options) {
    if (parts.empty()) throw InputError("combined_monitor: there is no part");
    for (const CombinedPart& part : parts) {
        if (!part.monitor) throw InputError("combined_monitor: a monitor is null");
        if (!std::isfinite(part.power)) throw InputError("combined_monitor: a power is not finite");
        if (!(part.weight > 0) || !std::isfinite(part.weight))
            throw InputError("combined_monitor: a weight is not positive and finite");
    }
    if (options.sharpness && (!(*options.sharpness > 0) || !std::isfinite(*options.sharpness)))
        throw InputError("combined_monitor: the sharpness is not positive and finite");
    return std::make_shared<CombinedMonitor>(std::move(parts), options);
}

} // namespace gaspard
