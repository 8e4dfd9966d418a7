#include "vnv/command/terminal.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::command {
namespace {

TEST(WrappedText, IsBrokenAtSpacesWithinItsColumns) {
  EXPECT_EQ(wrapped("water at rest between plates", 13), "water at rest\nbetween\nplates\n");
}

TEST(WrappedText, KeepsItsParagraphsAndItsIndent) {
  EXPECT_EQ(wrapped("one two\n\nthree", 9, 2), "  one two\n\n  three\n");
}

TEST(WrappedText, CountsLettersAndNotBytes) { EXPECT_EQ(wrapped("δδδ ρρρ x", 7), "δδδ ρρρ\nx\n"); }

TEST(WrappedText, LeavesALongWordWhole) { EXPECT_EQ(wrapped("a incompressible b", 6), "a\nincompressible\nb\n"); }

}  // namespace
}  // namespace touchstone::vnv::command
