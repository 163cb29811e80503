#include "render/viewer/key_places.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cctype>
#include <map>

namespace lumi {
namespace {

/// An American keyboard, but for some places.
KeyLabels keyboard(const std::map<int, std::string>& changed) {
    return [changed](int place) -> std::string {
        if (const auto found = changed.find(place); found != changed.end()) return found->second;
        if (place <= GLFW_KEY_SPACE || place > GLFW_KEY_GRAVE_ACCENT) return "";
        return {static_cast<char>(std::tolower(place))};
    };
}

const KeyLabels kAmerican = keyboard({});
const KeyLabels kGerman = keyboard({{'Y', "z"}, {'Z', "y"}, {'[', "ü"}, {']', "+"}});
const KeyLabels kFrench = keyboard({{'Q', "a"},
                                    {'A', "q"},
                                    {'W', "z"},
                                    {'Z', "w"},
                                    {';', "m"},
                                    {'M', ","},
                                    {'1', "&"},
                                    {'[', "^"},
                                    {']', "$"}});
const KeyLabels kColemak = keyboard({{'E', "f"},
                                     {'R', "p"},
                                     {'T', "g"},
                                     {'Y', "j"},
                                     {'U', "l"},
                                     {'I', "u"},
                                     {'O', "y"},
                                     {'P', ";"},
                                     {'S', "r"},
                                     {'D', "s"},
                                     {'F', "t"},
                                     {'G', "d"},
                                     {'J', "n"},
                                     {'K', "e"},
                                     {'L', "i"},
                                     {';', "o"},
                                     {'N', "k"}});
const KeyLabels kRussian = keyboard({{'W', "ц"}, {'Z', "я"}, {'M', "ь"}, {'Q', "й"}});
const KeyLabels kUnknown = [](int) { return std::string(); };

TEST(KeyMeant, IsTheKeyItselfOnAnAmericanKeyboardAndWhereNobodyKnowsWhatIsWritten) {
    for (const KeyLabels& labels : {kAmerican, kUnknown}) {
        for (const KeyBinding& binding : key_bindings()) {
            EXPECT_EQ(key_meant(binding.key, binding.with_control, labels), binding.key);
            EXPECT_EQ(shown_key(binding, labels), binding.shown);
        }
    }
}

TEST(KeyMeant, IsTheLetterThatIsWrittenOnTheKey) {
    EXPECT_EQ(key_meant('Y', false, kGerman), 'Z');
    EXPECT_NE(key_meant('Z', false, kGerman), 'Z');
    EXPECT_EQ(key_meant('A', true, kFrench), 'Q') << "Ctrl+Q quits";
    EXPECT_NE(key_meant('Q', true, kFrench), 'Q');
    EXPECT_EQ(key_meant(';', false, kFrench), 'M');
    EXPECT_NE(key_meant('M', false, kFrench), 'M');
}

TEST(KeyMeant, IsThatOfThePlaceWhereNoLatinLetterIsWritten) {
    EXPECT_EQ(key_meant('[', false, kGerman), '[');
    EXPECT_EQ(key_meant(']', false, kGerman), ']');
    EXPECT_EQ(key_meant('1', false, kFrench), '1');
    EXPECT_EQ(key_meant('M', false, kRussian), 'M');
    EXPECT_EQ(key_meant('Q', true, kRussian), 'Q');
}

TEST(KeyMeant, LeavesPlacesThatFlyAloneAndGivesTheirLettersAnotherKey) {
    for (const KeyLabels& labels : {kAmerican, kGerman, kFrench, kColemak, kRussian})
        for (const FlightKey& flight : kFlightKeys)
            EXPECT_EQ(key_meant(flight.key, false, labels), GLFW_KEY_UNKNOWN);
    // Z flies on a French keyboard; W has no meaning of its own.
    EXPECT_EQ(key_meant('Z', false, kFrench), 'Z');
    // R is written where S flies, S where D flies, and D on the key beside it.
    EXPECT_EQ(key_meant('G', false, kColemak), 'R');
}

TEST(KeyMeant, EveryCommandCanBeReachedAndNoKeyMeansTwo) {
    for (const KeyLabels& labels : {kAmerican, kGerman, kFrench, kColemak, kRussian}) {
        for (const KeyBinding& binding : key_bindings()) {
            int places = 0;
            for (int place = GLFW_KEY_SPACE; place <= GLFW_KEY_LAST; ++place)
                if (key_meant(place, binding.with_control, labels) == binding.key) ++places;
            EXPECT_EQ(places, 1) << binding.shown;
        }
    }
}

TEST(ShownKey, IsWhatIsWrittenOnTheKeyToPress) {
    const auto shown = [](Command command, const KeyLabels& labels) {
        for (const KeyBinding& binding : key_bindings())
            if (binding.command == command) return shown_key(binding, labels);
        return std::string();
    };
    EXPECT_EQ(shown(Command::kShowDepth, kGerman), "Z");
    EXPECT_EQ(shown(Command::kShowDepth, kFrench), "W");
    EXPECT_EQ(shown(Command::kPreviousPhotograph, kGerman), "ü");
    EXPECT_EQ(shown(Command::kNextPhotograph, kGerman), "+");
    EXPECT_EQ(shown(Command::kQuit, kFrench), "Ctrl+Q");
    EXPECT_EQ(shown(Command::kScreenshot, kFrench), "F12");
    EXPECT_EQ(shown_place('W', kFrench), "Z");
    EXPECT_EQ(shown_place('W', kUnknown), "W");
}

}  // namespace
}  // namespace lumi
