#include "pipeline/report/html.h"

#include <algorithm>
#include <charconv>

#include "calib/capture/image_io.h"
#include "calib/capture/jpeg_decoder.h"

namespace lumi {
namespace {

constexpr int kJpegQuality = 85;

constexpr const char* kStyle = R"(
:root{color-scheme:light dark}
body{font:16px/1.5 system-ui,sans-serif;max-width:72rem;margin:0 auto;padding:1rem;
 color:#1a1a1a;background:#fff}
h1{font-size:1.6rem;margin:.2em 0}h2{font-size:1.2rem;margin:2rem 0 .5rem;
 border-bottom:1px solid #ccc}
.wide{overflow-x:auto}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}
th,td{padding:.25rem .7rem;border-bottom:1px solid #ddd;text-align:left;vertical-align:top}
td.number{text-align:right}
.verdict{padding:.8rem 1rem;border-left:.5rem solid;margin:1rem 0;background:#f4f4f4}
.good{border-color:#1b7837}.fair{border-color:#b8860b}.bad{border-color:#b2182b}
figure{margin:.5rem 0}figcaption{font-size:.85rem;color:#555}
img{max-width:100%;height:auto;display:block}
.grid{display:grid;grid-template-columns:repeat(auto-fill,minmax(9rem,1fr));gap:.6rem}
pre{overflow-x:auto;background:#f4f4f4;padding:.7rem;font-size:.8rem}
summary{cursor:pointer;margin:.5rem 0}
@media(prefers-color-scheme:dark){body{color:#e6e6e6;background:#161616}
 .verdict,pre{background:#242424}th,td{border-color:#3a3a3a}h2{border-color:#444}
 figcaption{color:#aaa}}
)";

std::string data_uri(const std::string& type, std::span<const std::uint8_t> bytes) {
    return "data:" + type + ";base64," + base64(bytes);
}

std::string figure(const std::string& source, const std::string& caption) {
    const std::string text = html_escaped(caption);
    return "<figure><img src=\"" + source + "\" alt=\"" + text + "\"><figcaption>" + text +
           "</figcaption></figure>\n";
}

bool is_number(const std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
}

std::string cell(const std::string& text) {
    const std::string start = is_number(text) ? "<td class=\"number\">" : "<td>";
    return start + html_escaped(text) + "</td>";
}

}  // namespace

std::string html_escaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string base64(std::span<const std::uint8_t> bytes) {
    static constexpr char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = (group << 8U) | (i + k < bytes.size() ? bytes[i + k] : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool is_padding = k > 0 && i + k - 1 >= bytes.size();
            text += is_padding ? '=' : kDigits[(group >> (18U - 6U * k)) & 63U];
        }
    }
    return text;
}

std::string html_table(const std::vector<std::string>& headings,
                       const std::vector<std::vector<std::string>>& rows) {
    std::string html = "<div class=\"wide\"><table><thead><tr>";
    for (const std::string& heading : headings) html += "<th>" + html_escaped(heading) + "</th>";
    html += "</tr></thead><tbody>\n";
    for (const std::vector<std::string>& row : rows) {
        html += "<tr>";
        for (const std::string& text : row) html += cell(text);
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string html_figure(const ColorImage& picture, int max_width_px, const std::string& caption) {
    if (picture.width() <= max_width_px) {
        return figure(data_uri("image/jpeg", encode_jpeg(picture, kJpegQuality)), caption);
    }
    const int height_px = std::max(1, picture.height() * max_width_px / picture.width());
    const ColorImage small = resized(picture, max_width_px, height_px);
    return figure(data_uri("image/jpeg", encode_jpeg(small, kJpegQuality)), caption);
}

std::string html_svg_figure(const std::string& svg, const std::string& caption) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(svg.data());
    return figure(data_uri("image/svg+xml", {bytes, svg.size()}), caption);
}

std::string html_section(const std::string& heading, const std::string& content) {
    return "<section><h2>" + html_escaped(heading) + "</h2>\n" + content + "</section>\n";
}

std::string html_details(const std::string& heading, const std::string& content) {
    return "<details><summary>" + html_escaped(heading) + "</summary>\n" + content + "</details>\n";
}

std::string html_page(const std::string& title, const std::string& body) {
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           html_escaped(title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
           html_escaped(title) + "</h1>\n" + body + "</body></html>\n";
}

}  // namespace lumi
