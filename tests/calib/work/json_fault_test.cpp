#include "calib/work/json_fault.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

namespace lumi {
namespace {

using Json = nlohmann::json;

/// What is said of a text, or of what `use` asks of it.
template <class Use>
std::string said_of(const std::string& text, const Use& use) {
    try {
        use(Json::parse(text));
    } catch (const Json::exception& fault) {
        return json_fault("a.json", fault);
    }
    return "nothing";
}

std::string said_of(const std::string& text) {
    return said_of(text, [](const Json&) {});
}

TEST(JsonFault, OfWhatIsNoJsonLineAndColumnAreSaid) {
    EXPECT_EQ(said_of("{\n \"a\": 1,\n}"), "a.json:3:1: unexpected '}'; expected string literal");
    EXPECT_EQ(said_of(""), "a.json:1:1: unexpected end of input; expected '[', '{', or a literal");
    EXPECT_EQ(said_of("[1, 2"), "a.json:1:6: unexpected end of input; expected ']'");
    EXPECT_EQ(said_of("[\"a - b\" c]"),
              "a.json:1:10: invalid literal; last read: '\"a - b\" c'; expected ']'");
}

TEST(JsonFault, OfAValueWhatItLacksOrShouldBeIsSaid) {
    const std::string text = R"({"list": [1, 2], "word": "x"})";
    EXPECT_EQ(said_of(text, [](const Json& json) { return json.at("none"); }),
              "a.json: key 'none' not found");
    EXPECT_EQ(said_of(text, [](const Json& json) { return json.at("word").get<double>(); }),
              "a.json: a value's type must be number, but is string");
    EXPECT_EQ(said_of(text, [](const Json& json) { return json.at("list").at("x"); }),
              "a.json: expected another type of value than array");
    EXPECT_EQ(
        said_of(text,
                [](const Json& json) { return json.at("list").get<std::array<double, 3>>(); }),
        "a.json: array index 2 is out of range");
    EXPECT_EQ(said_of("[1e999]"), "a.json: number overflow parsing '1e999'");
}

}  // namespace
}  // namespace lumi
