#include "rtcore/scene/material_numbers.h"

#include "rtcore/io/text/scn.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace {

using rtcore::kMaterialNumbers;
using rtcore::MaterialNumber;
using rtcore::MaterialOverride;

rtcore::MaterialOverride parsed(const MaterialNumber& number, const std::string& value) {
    const std::array<std::string, 1> words{value};
    return rtcore::parseMaterialKey(number.key, words);
}

TEST(MaterialNumbers, AreReadWrittenAndApplied) {
    for (const MaterialNumber& number : kMaterialNumbers) {
        const MaterialOverride change = parsed(number, "1");
        EXPECT_EQ(change.*number.change, 1.0F) << number.key;
        EXPECT_NE(rtcore::formatMaterial(change).find(std::string(number.key) + " = 1"), std::string::npos);
        rtcore::Material material;
        material.*number.field = 0.5F;
        change.applyTo(material);
        EXPECT_EQ(material.*number.field, 1.0F) << number.key;
        MaterialOverride sum;
        sum.add(change);
        EXPECT_EQ(sum.*number.change, 1.0F) << number.key;
    }
}

TEST(MaterialNumbers, WholeOnesTakeNoOthers) {
    int whole = 0;
    for (const MaterialNumber& number : kMaterialNumbers) {
        if (!number.whole) continue;
        ++whole;
        EXPECT_ANY_THROW(parsed(number, "1.5")) << number.key;
        EXPECT_EQ(parsed(number, "2").*number.change, 2.0F) << number.key;
    }
    EXPECT_EQ(whole, 1) << "priority";
}

TEST(MaterialNumbers, AreRefusedBeyondTheirRange) {
    for (const MaterialNumber& number : kMaterialNumbers) {
        EXPECT_ANY_THROW(parsed(number, std::to_string(number.minimum - 0.5F))) << number.key;
        if (number.maximum == rtcore::kUnlimitedNumber) continue;
        EXPECT_ANY_THROW(parsed(number, std::to_string(number.maximum + 0.5F))) << number.key;
    }
}

} // namespace
