#include "render/gl/screen.h"

namespace lumi {
namespace {

const std::vector<std::uint32_t> kTwoTriangles{0, 1, 2, 0, 2, 3};

}  // namespace

Screen::Screen() : corners_({{0, 2}}) { corners_.upload({0, 0, 1, 0, 1, 1, 0, 1}, kTwoTriangles); }

void Screen::draw() const { corners_.draw(0, kTwoTriangles.size()); }

}  // namespace lumi
