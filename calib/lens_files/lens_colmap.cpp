#include <charconv>
#include <sstream>

#include "calib/lens_files/lens_readers.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

[[noreturn]] void refuse(const std::string& where, int line, const std::string& expected) {
    throw Error(ErrorKind::kBadInput, "E-LENS-FILE",
                where + ":" + std::to_string(line) + ": expected " + expected,
                "give a cameras.txt of COLMAP with one camera: CAMERA_ID MODEL WIDTH HEIGHT "
                "PARAMETERS");
}

template <class Number>
Number number_from(const std::string& word, const std::string& where, int line) {
    Number value{};
    const char* const end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) {
        refuse(where, line, "a number, found \"" + word + "\"");
    }
    return value;
}

Camera lens_from(const std::vector<std::string>& words, const std::string& where, int line) {
    constexpr std::size_t kBeforeParameters = 4;
    if (words.size() <= kBeforeParameters) {
        refuse(where, line, "CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS");
    }
    (void)number_from<long>(words[0], where, line);
    Camera lens;
    const auto model = lens_model_named(words[1]);
    if (!model) refuse(where, line, "a lens model that lumi knows, found \"" + words[1] + "\"");
    lens.model = *model;
    lens.width_px = number_from<int>(words[2], where, line);
    lens.height_px = number_from<int>(words[3], where, line);
    for (std::size_t index = kBeforeParameters; index < words.size(); ++index) {
        lens.parameters.push_back(number_from<double>(words[index], where, line));
    }
    validate(lens, where + ":" + std::to_string(line));
    return lens;
}

}  // namespace

Camera read_lens_colmap(const std::string& text, const std::string& where) {
    std::istringstream lines(text);
    std::string line_text;
    Camera lens;
    int cameras = 0;
    for (int line = 1; std::getline(lines, line_text); ++line) {
        std::istringstream stream(line_text);
        std::vector<std::string> words;
        for (std::string word; stream >> word;) words.push_back(word);
        if (words.empty() || words.front().starts_with("#")) continue;
        if (++cameras > 1) refuse(where, line, "one camera only");
        lens = lens_from(words, where, line);
    }
    if (cameras == 0) refuse(where, 1, "a camera");
    return lens;
}

}  // namespace lumi
