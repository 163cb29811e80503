#include "calib/ingest/photograph_order.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <numeric>

namespace lumi {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Takes a number, or a letter where there is none, from the front.
std::string_view take_front(std::string_view& name) {
    const auto end = std::find_if_not(name.begin(), name.end(), is_digit);
    const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(end - name.begin()));
    const std::string_view front = name.substr(0, length);
    name.remove_prefix(length);
    return front;
}

std::string_view without_zeros(std::string_view number) {
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
    return number;
}

std::strong_ordering compared(std::string_view first, std::string_view second) {
    if (!is_digit(first.front()) || !is_digit(second.front())) {
        return static_cast<unsigned char>(first.front()) <=>
               static_cast<unsigned char>(second.front());
    }
    first = without_zeros(first);
    second = without_zeros(second);
    if (first.size() != second.size()) return first.size() <=> second.size();
    return first <=> second;
}

}  // namespace

bool comes_before(std::string_view first, std::string_view second) {
    std::string_view rest_of_first = first;
    std::string_view rest_of_second = second;
    while (!rest_of_first.empty() && !rest_of_second.empty()) {
        const auto order = compared(take_front(rest_of_first), take_front(rest_of_second));
        if (order != std::strong_ordering::equal) return order < 0;
    }
    if (rest_of_first.empty() != rest_of_second.empty()) return rest_of_first.empty();
    return first < second;
}

std::vector<int> places_in_order(const std::vector<Photograph>& photographs) {
    std::vector<std::size_t> order(photographs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return comes_before(photographs[a].name, photographs[b].name);
    });
    std::vector<int> places(photographs.size());
    for (std::size_t place = 0; place < order.size(); ++place)
        places[order[place]] = static_cast<int>(place);
    return places;
}

}  // namespace lumi
