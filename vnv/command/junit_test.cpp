#include "vnv/command/junit.hpp"

#include <gtest/gtest.h>
#include <pugixml.hpp>

namespace touchstone::vnv::command {
namespace {

TEST(JUnit, HasATestCaseForEachClaimAndAFailureForEachThatDoesNotHold) {
  Record record;
  record.case_name = "poiseuille";
  record.method = "mine";
  record.verdicts.resize(3);
  const auto set = [&](std::size_t k, const char* level, const char* quantity, const char* author, Outcome outcome,
                       const char* sentence) {
    Verdict& v = record.verdicts[k];
    v.level = level;
    v.quantity = quantity;
    v.author = author;
    v.outcome = outcome;
    v.sentence = sentence;
  };
  set(0, "40 across", "L2 v_x", "theory: <exact>", Outcome::holds, "HOLDS");
  set(1, "", "order", "theory", Outcome::fails, "order < 1: FAILS");
  set(2, "", "order", "user", Outcome::inconclusive, "INCONCLUSIVE");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(junit_of(record).c_str()));
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  EXPECT_EQ(suite.attribute("name").as_string(), std::string("poiseuille.mine"));
  EXPECT_EQ(suite.attribute("tests").as_int(), 3);
  EXPECT_EQ(suite.attribute("failures").as_int(), 2);
  std::vector<std::string> said;
  for (const pugi::xml_node test : suite.children("testcase"))
    said.push_back(std::string(test.attribute("name").as_string()) + " | " +
                   test.child("failure").attribute("message").as_string());
  EXPECT_EQ(said, (std::vector<std::string>{"40 across: L2 v_x, theory: <exact> | ", "order, theory | order < 1: FAILS",
                                            "order, user | INCONCLUSIVE"}));
}

}  // namespace
}  // namespace touchstone::vnv::command
