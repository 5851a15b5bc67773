// Text on its way to a terminal and into XML.

#include "src/output/files/safe_text.hpp"

#include <gtest/gtest.h>

#include "src/output/vtkhdf/xdmf_text.hpp"

namespace percuss {
namespace {

TEST(PrintableText, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(make_printable("a\x1b[2Jb"), "a\\x1b[2Jb");
  EXPECT_EQ(make_printable(std::string_view("a\0b\r\x7f", 5)), "a\\x00b\\x0d\\x7f");
  EXPECT_EQ(make_printable("\xc2\x9b"
                           "31m"),
            "\\u009b31m");  // C1: CSI in one character
  EXPECT_EQ(make_printable("\xe2\x80\xae"
                           "cba"),
            "\\u202e"
            "cba");                                        // right-to-left override
  EXPECT_EQ(make_printable("\xe2\x81\xa6x"), "\\u2066x");  // isolate
  EXPECT_EQ(make_printable("\x9b"
                           "31m"),
            "\\x9b31m");  // C1 of Latin-1, which is no UTF-8
}

TEST(PrintableText, LeavesLinesAndLettersAsTheyAre) {
  const std::string text = "one\n\ttwo \xc3\xa4\xe6\xbc\xa2\xf0\x9f\x94\xa7 {} % \\";
  EXPECT_EQ(make_printable(text), text);
}

TEST(XmlText, HoldsOnlyCharactersOfXml) {
  EXPECT_EQ(escape_xml("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
  EXPECT_EQ(escape_xml("a\xef\xbf\xbe"
                       "b\xef\xbf\xbf"),
            "a\xef\xbf\xbd"
            "b\xef\xbf\xbd");  // U+FFFE, U+FFFF
  EXPECT_EQ(escape_xml("a\x1b\nb"), "a  b");
  EXPECT_EQ(escape_xml("\xff\xc2\x9b"), "\xef\xbf\xbd\xef\xbf\xbd");
}

TEST(XmlText, IsThatOfTitlesAndParts) {
  XdmfIndex index;
  index.title =
      "a\xef\xbf\xbe"
      "b";
  index.parts = {"\x1b[1m"};
  const std::string text = make_xdmf_text(index);
  EXPECT_EQ(text.find("\xef\xbf\xbe"), std::string::npos);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("a\xef\xbf\xbd"
                      "b"),
            std::string::npos);
}

}  // namespace
}  // namespace percuss
