/// Labels by which clients show the steps that `undo` takes back.
#pragma once

#include <string>
#include <string_view>

namespace app {

struct StepLabel {
    std::string_view text;  ///< of the table, in English: "temperature of light"; "": a line that no row has
    std::string of;         ///< the word behind the name, without its folder: a light's id; "": none
    bool isSetting = false; ///< `of` names a setting, which says all
};

/// The label of a step as `state` reports it, such as "light temperature 3" or "set bloom.radius". Throws
/// nothing but std::bad_alloc.
StepLabel stepLabel(const std::string& step);

} // namespace app
