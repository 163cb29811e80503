#include "pipeline/text/html.h"

#include <algorithm>
#include <charconv>

#include "calib/pictures/image_io.h"
#include "calib/pictures/jpeg_decoder.h"

namespace lumi {
namespace {

constexpr int kJpegQuality = 85;

constexpr const char* kStyle = R"(
:root{color-scheme:light dark;--ink:#1c1b19;--paper:#fbfaf7;--soft:#6b675f;--line:#ddd8cd;
 --card:#f1eee6}
body{font:17px/1.55 Georgia,'Times New Roman',serif;max-width:76rem;margin:0 auto;
 padding:1rem clamp(.8rem,3vw,2.5rem) 4rem;color:var(--ink);background:var(--paper)}
h1{font-size:clamp(1.7rem,5vw,2.6rem);font-weight:normal;margin:.4em 0 .5em}
h2{font-size:1.35rem;font-weight:normal;margin:3rem 0 .6rem;border-bottom:1px solid var(--line);
 padding-bottom:.2rem}
h3{font-size:1rem;margin:1.2rem 0 .3rem}
table,pre,summary,figcaption{font-family:system-ui,sans-serif}
.wide{overflow-x:auto}
table{border-collapse:collapse;font-size:.85rem;font-variant-numeric:tabular-nums;margin:.5rem 0}
th,td{padding:.25rem .7rem;border-bottom:1px solid var(--line);text-align:left;vertical-align:top}
th{font-weight:600;color:var(--soft)}
td.number{text-align:right;white-space:nowrap}
.verdict{padding:.9rem 1.1rem;border-left:.5rem solid;margin:1rem 0 2rem;background:var(--card)}
.good{border-color:#1b7837}.fair{border-color:#b8860b}.bad{border-color:#b2182b}
figure{margin:.6rem 0}figcaption{font-size:.82rem;color:var(--soft);margin-top:.3rem}
img{max-width:100%;height:auto;display:block}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,22rem),1fr));gap:.4rem 1rem;
 margin-top:1.2rem}
.grid{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,17rem),1fr));gap:.6rem 1rem}
.grid img,.pair img{width:100%}
pre{overflow-x:auto;background:var(--card);padding:.7rem;font-family:monospace;font-size:.8rem}
summary{cursor:pointer;margin:.5rem 0;color:var(--soft);font-size:.9rem}
@media(prefers-color-scheme:dark){:root{--ink:#e9e6df;--paper:#161513;--soft:#a39d91;
 --line:#3a3732;--card:#24221f}}
@media print{details{display:block}summary{display:none}}
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

std::string html_pair(const std::string& left, const std::string& right) {
    return "<div class=\"pair\">" + left + right + "</div>\n";
}

std::string html_grid(const std::string& figures) {
    return "<div class=\"grid\">" + figures + "</div>\n";
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
