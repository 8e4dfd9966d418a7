#include "vnv/doors/diagnosis/diagnosis.hpp"

#include "vnv/doors/diagnosis/where.hpp"
#include "vnv/doors/diagnosis/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace touchstone::vnv::doors {
namespace diagnosis {
namespace {

/// A mistake that may have been made, and the squared error that it leaves.
struct Made {
  Mistake mistake;
  double left;
};

class Diagnostician : public Fitter {
 public:
  using Fitter::Fitter;

  /// Fits all causes; what they are called is said later, when other resolutions have been heard.
  void fit() {
    if (!has_error() || !is_enough()) return;
    for (const Cause cause : causes_) single_.push_back(fitted({cause}, 1));
    if (best_share(single_) < one_is_enough && !is_noise(as_noise(seen_))) pairs_ = likely_pairs();
  }
  std::vector<Fit>& singles() { return single_; }

  /// The causes that are named by themselves.
  std::vector<Cause> named() const {
    std::vector<Cause> causes;
    for (const Fit* fit : names())
      if (fit->causes.size() == 1) causes.push_back(fit->causes[0]);
    return causes;
  }
  /// Those that a finer resolution names are named here too, where they are more than their interval.
  void hear(std::vector<Cause> of_finer) { told_ = std::move(of_finer); }

  Diagnosis diagnosis() const {
    Diagnosis all{.field = exact_.field};
    const LeftOut& out = seen_.left_out();
    if (out.no_numbers > 0)
      all.sentence = fmt::format("{:.0f} of {:.0f} rows hold no number; of the rest, ", out.no_numbers, out.rows);
    if (seen_.empty()) {
      all.sentence = out.no_numbers > 0 && out.no_numbers == out.rows
                         ? fmt::format("no row of the {} holds a number", exact_.field)
                         : fmt::format("the {} is zero at all these times", exact_.field);
      return all;
    }
    const double whole = squared() + out.squared;
    all.error = 100 * std::sqrt(whole / seen_.times());
    if (constexpr double worth_a_word = 0.2;
        out.apart > 0 && out.squared >= worth_a_word * whole && all.error > as_exact) {
      Explanation alone{.causes = {{"particles apart", "", out.apart, 0}}, .share = out.squared / whole, .named = true};
      alone.sentence =
          out.apart > 1
              ? fmt::format(
                    "{:.0f} particles apart, the worst at ({:.4g}, {:.4g}) m and {:g} s, make {:.4g} % of the squared error",
                    out.apart, out.x.x(), out.x.y(), out.time, 100 * alone.share)
              : fmt::format("one particle, at ({:.4g}, {:.4g}) m and {:g} s, makes {:.4g} % of the squared error",
                            out.x.x(), out.x.y(), out.time, 100 * alone.share);
      all.explanations.push_back(alone);
      all.sentence += alone.sentence;
      if (!has_error()) return all;
      all.sentence += "; of the rest, ";
    }
    if (!has_error())
      all.sentence += fmt::format("the {} has no error to speak of", exact_.field);
    else if (const std::vector<Made> made = mistakes_made(); !made.empty())
      say_mistakes(made, all);
    else if (is_enough())
      say_causes(all);
    else
      all.sentence +=
          fmt::format("{} numbers of the {} are too few for a diagnosis", seen_.error().size(), exact_.field);
    std::ranges::stable_sort(all.explanations, std::greater{}, &Explanation::named);
    return all;
  }

 private:
  static constexpr double one_is_enough = 0.995;  // share of the squared error; else two, if they leave a tenth

  // Mistakes

  /// Those that explain the error and cannot be told from the best, the plainest first.
  std::vector<Made> mistakes_made() const {
    constexpr double least_left = 0.2, least_left_of_nothing = 0.02, gross = 0.04;
    const VectorXd &found = seen_.numbers(), right = seen_.exact();
    const bool is_gross = squared() > gross * right.squaredNorm();
    std::vector<Made> all, twofold;
    const auto consider = [&](const Mistake& mistake, const VectorXd& shown, std::vector<Made>& among,
                              double stricter) {
      const double left = (found - mistake.scale * shown).squaredNorm();
      const double of = mistake.scale == 0 ? least_left_of_nothing * right.squaredNorm()
                                           : least_left * stricter * (mistake.scale * shown).squaredNorm();
      if (left <= least_left * squared() && left <= of) among.push_back({mistake, left});
    };
    const auto factor = [&](const VectorXd& shown) { return found.dot(shown) / shown.squaredNorm(); };
    if (const VectorXd across = seen_.across(); is_gross && across.norm() > 0) {
      const double left = (across - right).squaredNorm() + found.squaredNorm();
      if (left < least_left_of_nothing * right.squaredNorm())
        return {{{.cause = "components swapped", .sentence = "v_x and v_y are swapped", .scale = 0}, left}};
    }
    if (is_gross)
      for (const Mistake& mistake : mistakes_of_scale(exact_, factor(right))) consider(mistake, right, all, 1);
    for (const Mistake& mistake : mistakes_of_place_and_time(exact_, domain_, seen_.given_times())) {
      if ((!is_gross && !mistake.of_time) || !others_allow(mistake)) continue;
      const VectorXd shown = seen_.exact_with(mistake);
      if (!shown.allFinite() || !(shown.squaredNorm() > 1e-12 * right.squaredNorm())) continue;
      consider(mistake, shown, all, 1);
      if (!is_gross) continue;
      for (Mistake both : mistakes_of_scale(exact_, factor(shown)))
        if (both.scale != 0) {
          both.cause += " and " + mistake.cause, both.sentence += " and " + mistake.sentence, both.seen = mistake.seen;
          consider(both, shown, twofold, 0.1);
        }
    }
    const bool are_two = all.empty();
    if (are_two) all = std::move(twofold);
    if (all.empty()) return all;
    const double best = std::ranges::min(all, {}, &Made::left).left;
    const auto is_better = [&](const Fit& fit) {
      return fit.suffices() && fit.stands() && (are_two || is_small(fit)) && fit.rest.squaredNorm() < best / 10;
    };
    const bool is_exact = best < 1e-12 * right.squaredNorm();
    if (!is_exact && (std::ranges::any_of(single_, is_better) || std::ranges::any_of(pairs_, is_better))) return {};
    constexpr double alike = 1.02;
    std::erase_if(all, [&](const Made& one) { return one.left > alike * best + 1e-12 * right.squaredNorm(); });
    return all;
  }

  /// Whether a fit is no other name of a mistake: a factor that is 90 % off is one.
  static bool is_small(const Fit& fit) {
    for (std::size_t k = 0; k < fit.causes.size(); ++k) {
      const Cause cause = fit.causes[k];
      const bool is_factor = (cause >= Cause::force && cause <= Cause::sound_speed) || cause >= Cause::amplitude;
      if (is_factor && !(std::abs(fit.value[k]) < (fit.causes.size() > 1 ? 2 : 0.9))) return false;
    }
    return true;
  }

  void say_mistakes(const std::vector<Made>& made, Diagnosis& all) const {
    constexpr std::size_t most_said = 4;
    std::vector<std::string> sentences;
    const Made& best = made.front();
    for (const Made& one : std::span(made).first(std::min(made.size(), most_said))) {
      const Mistake& m = one.mistake;
      all.explanations.push_back({.causes = {{m.cause, m.unit, m.value, 0}},
                                  .share = 1 - one.left / squared(),
                                  .named = true,
                                  .sentence = m.sentence});
      sentences.push_back(m.sentence);
    }
    for (const Fit& fit : single_) {
      const bool is_alike = best.mistake.scale == 1 && fit.suffices() && fit.stands() && is_small(fit) &&
                            fit.rest.squaredNorm() <= 1.1 * best.left + 1e-10 * squared();
      all.explanations.push_back(explanation(fit, seen_, spacing_, is_alike));
      if (is_alike) sentences.push_back(all.explanations.back().sentence);
    }
    all.sentence += fmt::format("{}, which explains {:.4g} % of the squared error", sentences[0],
                                100 * (1 - best.left / squared()));
    for (std::size_t k = 1; k < sentences.size(); ++k)
      all.sentence += (k == 1 ? "; or, indistinguishable by these data: " : "; or ") + sentences[k];
    if (best.mistake.scale == 0 || !is_enough()) return;
    constexpr double worth_a_word = 0.5;  // %
    if (const Diagnosis rest = causes_alone(FieldVector(seen_, best.mistake));
        rest.error > worth_a_word && names_any(rest))
      all.sentence += fmt::format("; of the {:.3g} % that are left, {}", rest.error, rest.sentence);
  }

  /// Of another error at this resolution, in which no mistakes are looked for.
  Diagnosis causes_alone(FieldVector other) const {
    Diagnostician of_it(exact_, std::move(other), domain_, spacing_, discretisation_);
    of_it.fit();
    Diagnosis all{.field = exact_.field, .error = 100 * std::sqrt(of_it.squared() / of_it.seen_.times())};
    if (of_it.has_error()) of_it.say_causes(all);
    return all;
  }
  static bool names_any(const Diagnosis& found) {
    return !found.explanations.empty() && found.explanations.front().named;
  }

  // Causes

  void say_causes(Diagnosis& all) const {
    std::vector<const Fit*> fits = pointers(single_);
    std::ranges::copy(pointers(pairs_), std::back_inserter(fits));
    const std::vector<const Fit*> named = names();
    const Fit* best = best_of(named, [](const Fit&) { return true; });
    std::vector<Explanation> explanations;
    for (const Fit* fit : fits)
      explanations.push_back(
          explanation(*fit, seen_, spacing_, std::ranges::find(named, fit) != named.end(), fit == best));
    const Explanation noise = explanations.emplace_back(as_noise(seen_));
    explanations.back().named = named.empty() && is_noise(noise);
    std::ranges::stable_sort(explanations, std::greater{},
                             [](const Explanation& e) { return std::pair(e.named, e.share); });
    if (explanations.front().named)
      all.sentence += in_words(explanations);
    else if (say_time_alone(all))
      return;
    else if (std::ranges::any_of(fits, [&](const Fit* fit) { return is_discretisation(*fit); }))
      all.sentence +=
          fmt::format("the error of the {} is no more than discretisation may make at this resolution: finer ones tell",
                      exact_.field);
    else
      all.sentence += nothing_explains(fits);
    std::ranges::move(explanations, std::back_inserter(all.explanations));
  }

  /// Where all of the error is that of one time and something is known of it there.
  bool say_time_alone(Diagnosis& all) const {
    constexpr double nearly_all = 0.95;
    if (seen_.moments().size() < 2) return false;
    for (std::size_t k = 0; k < seen_.moments().size(); ++k) {
      FieldVector alone(seen_, k);
      if (alone.error().squaredNorm() < nearly_all * squared()) continue;
      const Diagnosis found = causes_alone(std::move(alone));
      if (!names_any(found)) return false;
      all.sentence += fmt::format("only at {:g} s is there an error: {}", seen_.moments()[k].time, found.sentence);
      all.explanations.insert(all.explanations.end(), found.explanations.begin(), found.explanations.end());
      return true;
    }
    return false;
  }

  /// Causes by themselves or two at once: those that a finer resolution names, else those that these data name.
  std::vector<const Fit*> names() const {
    std::vector<const Fit*> named;
    for (const Fit& fit : single_)
      if (fit.stands() && std::ranges::find(told_, fit.causes[0]) != told_.end()) named.push_back(&fit);
    if (!named.empty()) return named;
    const double by_one = best_share(single_), by_two = best_share(pairs_);
    if (by_two > 0 && (by_one == 0 || 1 - by_two < (1 - by_one) / 10)) named = name(pairs_);
    return named.empty() ? name(single_) : named;
  }

  bool is_noise(const Explanation& noise) const { return best_share(single_) == 0 && noise.share >= sufficient; }

  std::string nothing_explains(const std::vector<const Fit*>& fits) const {
    std::string sentence = fmt::format("none of the known causes explains the error of the {}", exact_.field);
    constexpr double worth_a_word = 0.3;
    if (const Fit* best = best_of(fits, [](const Fit& fit) { return fit.stands() && fit.share > worth_a_word; }))
      sentence += fmt::format(": the best, {}, explains {:.0f} % of its square",
                              explanation(*best, seen_, spacing_, false).sentence, 100 * best->share);
    std::vector<Located> all;
    seen_.each([&](const Moment& m, int, Index first) {
      for (Index p = 0; p < m.x.cols(); ++p)
        all.push_back({m.x.col(p), m.weight[p] * m.weight[p], std::pow(seen_.error()[first + p], 2)});
    });
    return sentence + "; " + where_it_lies(all, domain_, spacing_);
  }

  static std::vector<const Fit*> pointers(const std::vector<Fit>& fits) {
    std::vector<const Fit*> all;
    for (const Fit& fit : fits) all.push_back(&fit);
    return all;
  }
  /// That of the largest share among those that may be; null where none may.
  static const Fit* best_of(const std::vector<const Fit*>& fits, const auto& may_be) {
    const Fit* best = nullptr;
    for (const Fit* fit : fits)
      if (may_be(*fit) && (!best || fit->share > best->share)) best = fit;
    return best;
  }
  static double best_share(const std::vector<Fit>& fits) {
    double best = 0;
    for (const Fit& fit : fits)
      if (fit.suffices()) best = std::max(best, std::min(1.0, fit.net()));
    return best;
  }

  /// The best that suffices and those to which it adds nothing; none where the best is less than its interval.
  std::vector<const Fit*> name(const std::vector<Fit>& fits) const {
    std::vector<const Fit*> named = pointers(fits);
    const Fit* best = best_of(named, [](const Fit& fit) { return fit.suffices(); });
    if (!best || !best->stands()) return {};
    // What leaves a ten thousandth of the error at most is told from all that leave ten times as much: no
    // discretisation blurs these data.
    const double all = std::min(squared(), seen_.numbers().squaredNorm());
    const double most = best->rest.squaredNorm() <= 1e-8 * all ? 1e-6 * all : HUGE_VAL;
    std::erase_if(named, [&](const Fit* fit) {
      const auto adds_to_it = [&](Cause cause) {
        return std::ranges::find(fit->causes, cause) == fit->causes.end() && adds(*fit, cause);
      };
      const auto is_as_good = [&] {
        return fit->suffices() && fit->stands() && std::ranges::none_of(best->causes, adds_to_it);
      };
      return fit != best && (fit->rest.squaredNorm() > most || !is_as_good());
    });
    return named;
  }

  std::vector<Fit> single_{}, pairs_{};
  std::vector<Cause> told_{};
};

/// Of each cause by itself what all resolutions say together: its interval at one of them reaches over that of its
/// value at vanishing spacing. A wall may be off by a length or by a part of a spacing.
void hear_all_resolutions(std::vector<Diagnostician>& levels) {
  std::vector<Diagnostician*> heard;
  for (Diagnostician& level : levels)
    if (!level.singles().empty()) heard.push_back(&level);
  if (heard.size() < 2) return;
  for (std::size_t k = 0; k < heard[0]->singles().size(); ++k) {
    const auto count = static_cast<Index>(heard.size());
    VectorXd value(count), deviation(count), made(count), spacing(count);
    bool possible = true;
    for (Index l = 0; l < count; ++l) {
      const Fit& fit = heard[l]->singles()[k];
      possible &= fit.possible && fit.deviation.allFinite() && fit.discretised[0] > 0;
      value[l] = fit.value[0], deviation[l] = fit.deviation[0], made[l] = fit.discretised[0];
      spacing[l] = heard[l]->spacing();
    }
    if (!possible) continue;
    Line line = line_of(value, deviation, made);
    VectorXd unit = VectorXd::Ones(count);
    const Cause cause = heard[0]->singles()[k].causes[0];
    bool in_metres = is_of_wall(cause);
    if (in_metres) {
      const Line in_spacings =
          line_of(value.cwiseQuotient(spacing), deviation.cwiseQuotient(spacing), made.cwiseQuotient(spacing));
      if (in_spacings.scatter < line.scatter) line = in_spacings, unit = spacing, in_metres = false;
    }
    if (!std::isfinite(line.at_zero.value) || !std::isfinite(line.at_zero.half_width)) continue;
    for (Index l = 0; l < count; ++l) {
      Fit& fit = heard[l]->singles()[k];
      const Extrapolated here{unit[l] * line.at_zero.value, unit[l] * line.at_zero.half_width};
      fit.vanishing = {here};
      fit.in_metres = in_metres;
      fit.half_width[0] = std::abs(fit.value[0] - here.value) + here.half_width;
    }
  }
}

}  // namespace
}  // namespace diagnosis

std::vector<Diagnosis> diagnose(const Exact& exact, const std::vector<Diagnosed>& levels, const Domain& domain,
                                double discretisation, const std::vector<const Exact*>& others) {
  using namespace diagnosis;
  std::vector<Diagnostician> all;
  for (const Diagnosed& level : levels) {
    std::vector<FieldVector> seen;
    for (const Exact* other : others)
      if (FieldVector one(*other, level.samples, domain); !one.empty()) seen.push_back(std::move(one));
    all.emplace_back(exact, FieldVector(exact, level.samples, domain), domain, level.spacing, discretisation,
                     std::move(seen));
    all.back().fit();
  }
  hear_all_resolutions(all);
  if (all.size() > 1) {
    const Diagnostician& finest = *std::ranges::min_element(all, {}, &Diagnostician::spacing);
    const std::vector<Cause> named = finest.named();
    for (Diagnostician& level : all)
      if (&level != &finest) level.hear(named);
  }
  std::vector<Diagnosis> found;
  for (const Diagnostician& level : all) found.push_back(level.diagnosis());
  return found;
}

}  // namespace touchstone::vnv::doors
