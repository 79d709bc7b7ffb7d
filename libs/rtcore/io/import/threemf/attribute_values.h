/// Values of attributes in the model parts of 3MF packages. What is no value is as if it were not there.
#pragma once

#include "rtcore/io/import/threemf/model_part.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace rtcore::threemf {

using Value = std::optional<std::string_view>;

std::uint32_t numberOf(Value text);        ///< kNoNumber where there is none
float realOf(Value text, float otherwise); ///< finite
float coordinateOf(Value text);            ///< no number where there is none
Paint paintOf(Value text);                 ///< #RRGGBB or #RRGGBBAA; else grey
Affine transformOf(Value text);            ///< 12 numbers; else none
TextureWrap wrapOf(Value text);
double metresOf(std::string_view unit); ///< a millimetre for what is no unit

void forEachWord(std::string_view text, const std::function<void(std::string_view)>& use);
/// Those that are no numbers are kNoNumber.
std::vector<std::uint32_t> numbersOf(Value text);

} // namespace rtcore::threemf
