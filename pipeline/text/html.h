#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// Text as it may stand in HTML, in an element or in a quoted attribute.
[[nodiscard]] std::string html_escaped(const std::string& text);

[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// A table of plain texts; cells are escaped here. Numbers are set right.
[[nodiscard]] std::string html_table(const std::vector<std::string>& headings,
                                     const std::vector<std::vector<std::string>>& rows);

/// A picture inside the page, at most `max_width_px` wide, with a caption (escaped here).
[[nodiscard]] std::string html_figure(const ColorImage& picture, int max_width_px,
                                      const std::string& caption);
/// An SVG drawing inside the page. It is shown as a picture, so that nothing in it can run.
[[nodiscard]] std::string html_svg_figure(const std::string& svg, const std::string& caption);

/// Two figures side by side where the screen is wide enough, one below the other where it is not.
[[nodiscard]] std::string html_pair(const std::string& left, const std::string& right);
/// Figures in as many columns as the screen has room for.
[[nodiscard]] std::string html_grid(const std::string& figures);

/// A part of the page, with a heading (escaped here).
[[nodiscard]] std::string html_section(const std::string& heading, const std::string& content);
/// Folded at first.
[[nodiscard]] std::string html_details(const std::string& heading, const std::string& content);

/// A whole page around `body`, with the style that all reports share.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

}  // namespace lumi
