#include "calib/ingest/photograph_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace lumi {
namespace {

TEST(PhotographOrder, CountsAsPeopleDo) {
    const std::vector<std::string> in_order{
        "",         "007.jpg",    "7.jpg",       "8.jpg",         "08b.jpg",
        "10.jpg",   "IMG_99.jpg", "IMG_100.jpg", "IMG_100_2.jpg", "a/2.jpg",
        "a/10.jpg", "a10/1.jpg",  "\xc3\xbc.jpg"};
    for (std::size_t a = 0; a < in_order.size(); ++a)
        for (std::size_t b = 0; b < in_order.size(); ++b)
            EXPECT_EQ(comes_before(in_order[a], in_order[b]), a < b)
                << in_order[a] << " " << in_order[b];
}

TEST(PhotographOrder, ComparesNumbersOfAnyLength) {
    EXPECT_TRUE(comes_before("9", "12345678901234567890123"));
    EXPECT_FALSE(comes_before("12345678901234567890124", "12345678901234567890123"));
    EXPECT_TRUE(comes_before("x0", "x00000000000000000000001"));
}

TEST(PhotographOrder, GivesEachPhotographItsPlace) {
    std::vector<Photograph> photographs(4);
    photographs[0].name = "1.png";
    photographs[1].name = "10.png";
    photographs[2].name = "11.png";
    photographs[3].name = "2.png";
    EXPECT_THAT(places_in_order(photographs), testing::ElementsAre(0, 2, 3, 1));
    EXPECT_THAT(places_in_order({}), testing::IsEmpty());
}

}  // namespace
}  // namespace lumi
