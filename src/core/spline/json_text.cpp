#include "core/spline/json_text.hpp"

#include "core/base/error.hpp"

#include <set>
#include <vector>

namespace gaspard {

namespace {

using Json = nlohmann::json;

/// Finds what the library's parser accepts silently (keys that occur twice, many levels) or reports in its
/// own words.
class JsonCheck final : public Json::json_sax_t {
  public:
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }
    bool key(string_t& name) override {
        if (!keys_.back().insert(name).second) throw InputError("the key '" + name + "' occurs twice");
        return true;
    }
    bool parse_error(std::size_t position, const std::string& token, const Json::exception& error) override {
        const std::string where = " at character " + std::to_string(position);
        if (dynamic_cast<const Json::out_of_range*>(&error))
            throw InputError("the number " + token.substr(0, 40) + where + " is too large");
        throw InputError("JSON syntax error" + where);
    }

  private:
    bool enter() {
        constexpr std::size_t deepest = 100;
        if (keys_.size() == deepest) throw InputError("the JSON has more than 100 levels");
        keys_.emplace_back();
        return true;
    }
    bool leave() {
        keys_.pop_back();
        return true;
    }

    std::vector<std::set<std::string>> keys_; ///< of the objects that are open; empty for lists
};

} // namespace

nlohmann::json parse_json(std::string_view text) {
    JsonCheck check;
    Json::sax_parse(text, &check);
    return Json::parse(text);
}

} // namespace gaspard
