#include "calib/work/printable.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(Printable, KeepsLettersOfAnyLanguage) {
    for (const char* text : {"", "IMG_0001.jpg", "a b/ünï-日本/$(x)", "\xf0\x9f\x93\xb7"}) {
        EXPECT_EQ(printable(text), text);
    }
}

TEST(Printable, EscapesControlCharacters) {
    EXPECT_EQ(printable("\x1b]0;x\x07"), "\\x1b]0;x\\x07");
    EXPECT_EQ(printable("a\nb\tc\x7f"), "a\\x0ab\\x09c\\x7f");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b") << "CSI as one C1 character";
    EXPECT_EQ(printable("\xc2\xa0"), "\xc2\xa0") << "the first character behind C1";
}

TEST(Printable, KnowsUtf8) {
    for (const char* text : {"", "caf\xc3\xa9.jpg", "\x1b[2J", "\xf0\x9f\x93\xb7"}) {
        EXPECT_TRUE(is_utf8(text)) << text;
    }
    for (const char* text :
         {"caf\xe9.jpg", "\xc0\xae", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2"}) {
        EXPECT_FALSE(is_utf8(text)) << printable(text);
    }
}

TEST(Printable, EscapesWhatIsNotUtf8) {
    EXPECT_EQ(printable("\xe9"), "\\xe9");
    EXPECT_EQ(printable("\xc0\xae"), "\\xc0\\xae") << "overlong";
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond U+10FFFF";
    EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82") << "cut short";
}

}  // namespace
}  // namespace lumi
