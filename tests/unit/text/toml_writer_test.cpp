#include "rtcore/io/text/toml_writer.h"

#include "rtcore/io/text/toml_parser.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace {

TEST(TomlWriter, WhatATerminalObeysIsWrittenByItsNumber) {
    EXPECT_EQ(rtcore::tomlString("a\x1b\u009b\u202e\u200f\u2028z"),
              "\"a\\u001B\\u009B\\u202E\\u200F\\u2028z\"");
    EXPECT_EQ(rtcore::tomlString("\u00e4 \u05d0\u200d\n\"\\"), "\"\u00e4 \u05d0\u200d\\n\\\"\\\\\"");
}

TEST(TomlWriter, AndIsReadAsItWas) {
    const auto reread = [](const std::string& text) {
        const rtcore::TextValue root = rtcore::parseToml("x = " + rtcore::tomlString(text) + "\n", "x");
        return std::get<std::string>(std::get<rtcore::TextTable>(root.content).entries.at(0).value.content);
    };
    for (const char* text : {"", "a\x01\u202ez", "\u061c\u2069", "\U0001F4A1"}) EXPECT_EQ(reread(text), text);
}

} // namespace
