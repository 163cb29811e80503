#include "calib/work/nearest_word.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

const std::set<std::string> kCommands{"build", "bench", "doctor", "poses", "view"};

TEST(NearestWord, IsFoundBehindSwappedMissingAndForeignLetters) {
    for (const char* misspelt : {"biuld", "buld", "buiild", "guild", "build"}) {
        EXPECT_EQ(nearest_word(misspelt, kCommands), "build") << misspelt;
    }
}

TEST(NearestWord, IsNoneWhereHalfOfTheLettersDiffer) {
    EXPECT_EQ(nearest_word("quantum", kCommands), std::nullopt);
    EXPECT_EQ(nearest_word("photographs", kCommands), std::nullopt);
    EXPECT_EQ(nearest_word("build", {}), std::nullopt);
}

}  // namespace
}  // namespace lumi
