#include "reports/paper/paper.hpp"

#include "reports/paper/latex.hpp"
#include "reports/paper/references.hpp"
#include "reports/testing.hpp"
#include "vnv/files/data_folder.hpp"
#include "vnv/programs/limited.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace touchstone::reports {
namespace paper_test {

namespace fs = std::filesystem;

const fs::path literature = vnv::data_folder() / "references.bib";

TEST(Latex, HasNoLetterThatIsACommand) {
  EXPECT_EQ(latex("50 % & $5 #1 {x} a~b \\input{x} <i> | \"q\""),
            "50 \\% \\& \\$5 \\#1 \\{x\\} a\\textasciitilde{}b \\textbackslash{}input\\{x\\} $<$i$>$ $|$ "
            "''q''");
  EXPECT_EQ(latex("mpm_reset ^ \\^"), "mpm\\_reset \\textasciicircum{} \\textbackslash{}\\textasciicircum{}");
  EXPECT_EQ(latex("two\nlines\x01"), "two lines ");
}

TEST(Latex, SetsSymbolsPowersAndSignsAsInPrint) {
  EXPECT_EQ(latex("L2 v_x ≤ 10^-3 m²/s ± 1"),
            "L2 $v_{\\mathrm{x}}$ $\\le$ 10\\textsuperscript{$-$3} m\\textsuperscript{2}/s $\\pm$ 1");
  EXPECT_EQ(latex("µs\u202f10–20 Lobovský"), "\\textmu{}s\\,10--20 Lobovský");
}

TEST(Latex, WritesNumbersWithPowersAndWhatIsNotFinite) {
  EXPECT_EQ(latex(0.0159), "$0.0159$");
  EXPECT_EQ(latex(-1.5e-7), "${-1.5\\times10^{-7}}$");
  EXPECT_EQ(latex(vnv::not_a_number), "nan");
  EXPECT_EQ(latex(-std::numeric_limits<double>::infinity()), "$-\\infty$");
}

std::vector<std::string> keys_of(const std::vector<Reference>& references) {
  std::vector<std::string> keys;
  for (const Reference& one : references) keys.push_back(one.key);
  return keys;
}

TEST(References, AreReadFromTheDataWithoutWhatBibTeXDoesNotKnow) {
  const std::vector<Reference> all = read_references(literature);
  ASSERT_GT(all.size(), 20u);
  for (const Reference& one : all) {
    EXPECT_TRUE(contains(one.entry, "{" + one.key + ",\n")) << one.entry;
    EXPECT_TRUE(contains(one.entry, "\n  author = {") && contains(one.entry, "\n  title = {")) << one.entry;
    EXPECT_TRUE(one.entry.ends_with("}\n")) << one.entry;
    EXPECT_FALSE(contains(one.entry, "named = ") || contains(one.entry, "oracle_of = ")) << one.entry;
  }
}

TEST(References, AreThoseThatATextNames) {
  const auto named = [all = read_references(literature)](const std::string& text) {
    return keys_of(named_in(text, all));
  };
  using Keys = std::vector<std::string>;
  EXPECT_EQ(named("literature: Sun et al., table 3, S2"), Keys{"sun_comparative"});
  EXPECT_EQ(named("particle shifting (Sun et al. 2017)"), Keys{"sun_2017"});
  EXPECT_EQ(named("Adami, Hu & Adams 2013"), Keys{"adami_2013"});
  EXPECT_EQ(named("given to the nodes as in MLS-MPM (Hu et al. 2018)"), Keys{"hu_2018"});
  EXPECT_EQ(named("theory: a consistent method is of first order at least"), Keys{});
}

TEST(References, OfACaseAreThoseItNamesAndThoseOfItsExactSolution) {
  vnv::Record record = sample_record();
  record.case_name = "stokes_second_H=1";
  record.method_description = "the density diffusion of Antuono et al. (2010)";
  EXPECT_EQ(keys_of(references_of({record.case_name, {record}}, read_references(literature))),
            (std::vector<std::string>{"sun_comparative", "stokes_1851", "antuono_2010"}));
}

TEST(References, ThatAreNoneAreRefusedByFileAndKey) {
  const ScratchFolder folder;
  const auto refusal = [&](const std::string& text) -> std::string {
    std::ofstream(folder / "a.bib") << text;
    try {
      read_references(folder / "a.bib");
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(folder.path().string().size() + 1, 30);
    }
    return "read without complaint";
  };
  EXPECT_EQ(refusal("@book{a,\n  title = {x}\n}\n"), "a.bib: a: no field 'named', ex");
  EXPECT_EQ(refusal("@book{a,\n  named = {[}\n}\n"), "a.bib: a: '[' or '' is no regu");
  EXPECT_EQ(refusal("@book{a,\n  named = {x{9999999999}}\n}\n"), "a.bib: a: 'named' or 'oracle_o");
  EXPECT_EQ(refusal("@book{a,\n  named = {x}\n}\n@book{a,\n  named = {x}\n}\n"), "a.bib: a: duplicate key, expec");
}

class Export : public testing::Test {
 protected:
  Export() {
    fs::create_directory(records);
    vnv::Record record = sample_record("mpm_a&b");
    record.revision = "abc_1";
    record.verdicts[0].method = record.method;
    record.values = {{"M2", 1.25e-3, 0.5, {"L2 v_x", "%", vnv::Kind::norm}, 3.75}};
    vnv::write(record, records / "a.json");
  }
  Paper written() const { return write_paper(records, "poiseuille", literature, paper); }
  std::string text(const std::string& name) const { return read_whole(paper / name); }

  ScratchFolder folder;
  const fs::path records = folder / "records", paper = folder / "paper";
};

TEST_F(Export, HasTablesDataVersionsAndCitations) {
  const Paper all = written();
  EXPECT_EQ(all.missing, std::vector<std::string>{});
  for (const fs::path& file : all.files) EXPECT_GT(fs::file_size(file), 0u) << file;
  EXPECT_TRUE(contains(text("verdicts.tex"),
                       "\\textit{mpm\\_a\\&b}} \\\\*\nM2 & L2 $v_{\\mathrm{x}}$ & $1.5$ \\% & $\\le$ $1.59$ \\% & "
                       "literature: Sun et al., table 3~\\cite{sun_comparative} & holds \\\\[1.5pt]\n\\end{longtable}"))
      << text("verdicts.tex");
  EXPECT_TRUE(contains(text("versions.tex"), "methods & mpm\\_a\\&b \\\\[1.5pt]\nrevision & abc\\_1 \\\\[1.5pt]\n"))
      << text("versions.tex");
  EXPECT_TRUE(contains(text("versions.csv"), "\nmpm_a&b,abc_1,")) << text("versions.csv");
  EXPECT_TRUE(contains(text("values.csv"), "\npoiseuille,mpm_a&b,M2,0.00125,0.5,L2 v_x [%],3.75\n"));
  EXPECT_TRUE(contains(text("verdicts.csv"), "\npoiseuille,mpm_a&b,M2,"));
  EXPECT_TRUE(contains(text("references.bib"), "@article{morris_1997,\n")) << "of the exact solution";
}

TEST_F(Export, DrawsEachFigureAsPdfBesideItsScriptAndData) {
  written();
  EXPECT_EQ(text("profile.pdf").substr(0, 5), "%PDF-");
  EXPECT_TRUE(contains(text("profile.gp"), "pdfcairo"));
  EXPECT_FALSE(text("profile.csv").empty());
}

TEST_F(Export, GivesEachNameToOneContentWhereAFigureHasThatOfATable) {
  vnv::Record record = sample_record();
  record.figures[0].id = record.curves[0].figure = record.curves[1].figure = "cost";
  vnv::write(record, records / "a.json");
  Paper all = written();
  EXPECT_TRUE(text("cost.csv").starts_with("case,method,level,")) << text("cost.csv");
  EXPECT_TRUE(text("figure_cost.csv").starts_with("curve,y [mm]")) << text("figure_cost.csv");
  EXPECT_EQ(text("figure_cost.pdf").substr(0, 5), "%PDF-");
  std::ranges::sort(all.files);
  EXPECT_EQ(std::ranges::adjacent_find(all.files), all.files.end());
}

TEST_F(Export, IsCompiledByLaTeXWithinTheWidthOfItsText) {
  const auto works = [](const std::string& command) {
    return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
  };
  if (!works("command -v pdflatex") || !works("command -v bibtex") || !works("kpsewhich booktabs.sty"))
    GTEST_SKIP() << "pdflatex, bibtex or booktabs not found: apt install texlive-latex-recommended";
  vnv::Record record = sample_record("sph_regularised_float");
  record.flags = "-O3 -fno-math-errno -fno-trapping-math -march=native";
  record.machine = "AMD EPYC, 2 processors";
  for (const char* level : {"20 cells, 1 per cell, 69.2 us", "", "Re 1000, 100 across"}) {
    vnv::Verdict verdict = sample_verdict(vnv::Outcome::inconclusive, 0);
    verdict.level = level;
    verdict.time = 0.0125;
    verdict.quantity = "order of L2 p - mean(p), per particle over points per cell, cells of 0.025 mm";
    verdict.unit = "%";
    verdict.value = -1.2345e-12;
    verdict.lower = -1.2345e-12;
    verdict.upper = 2.3456e-12;
    verdict.author = "literature: Lobovský et al. 2014, ± 10⁻¹ of L, “read” from (38) & figure 12(a)";
    for (int k = 0; k < 40; ++k) record.verdicts.push_back(verdict);
  }
  vnv::write(record, records / "b.json");
  written();
  fs::copy_file(literature, paper / "literature.bib");
  std::string cited;
  for (const std::string& key : keys_of(read_references(literature))) cited += "\\cite{" + key + "} ";
  std::ofstream(paper / "document.tex")
      << "\\documentclass{article}\n\\usepackage{array,booktabs,graphicx,longtable,textcomp}\n"
         "\\begin{document}\n\\input{verdicts}\n\\input{versions}\n\\noindent\\includegraphics[width=\\linewidth]{profile.pdf}\n"
      << cited << "\n\\bibliographystyle{plain}\n\\bibliography{literature}\n\\end{document}\n";
  const programs::Words latex_it{"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "document"};
  for (const programs::Words& words : {latex_it, {"bibtex", "document"}, latex_it, latex_it, latex_it})
    ASSERT_TRUE(programs::run_limited(words[0], words, paper, paper / "said.txt", {}).succeeded()) << text("said.txt");
  EXPECT_GT(fs::file_size(paper / "document.pdf"), 0u);
  std::istringstream log(text("document.log"));
  for (std::string line; std::getline(log, line);)
    for (const char* complaint : {"Warning", "Overfull", "Missing character"})
      EXPECT_FALSE(contains(line, complaint)) << line;
  EXPECT_FALSE(contains(text("document.blg"), "Warning--")) << text("document.blg");
}

TEST_F(Export, SaysInOneLineThatItCouldNotDrawAndWritesAllElse) {
  const Environment without("PATH", "/nonexistent");
  const Paper all = written();
  ASSERT_EQ(all.missing.size(), 1u);
  EXPECT_TRUE(contains(all.missing[0], "figures are left as scripts and data: gnuplot: not found")) << all.missing[0];
  EXPECT_FALSE(contains(all.missing[0], "\n"));
  EXPECT_FALSE(fs::exists(paper / "profile.pdf"));
  EXPECT_FALSE(text("profile.gp").empty() || text("verdicts.tex").empty());
}

TEST_F(Export, NamesTheCasesThatThereAreWhereItsCaseIsNone) {
  try {
    write_paper(records, "couette", literature, paper);
    FAIL() << "written without complaint";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "no case 'couette', expected one of: poiseuille")) << error.what();
  }
  EXPECT_FALSE(fs::exists(paper));
}

}  // namespace paper_test
}  // namespace touchstone::reports
