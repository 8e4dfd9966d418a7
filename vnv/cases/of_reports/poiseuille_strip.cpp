/// Work-precision diagram of start-up plane Poiseuille flow in no more of the channel than the flow needs: nothing
/// varies along it, so a strip is enough that fills a vector register with cells, or holds a kernel of SPH.

#include "vnv/flows/channels/channel_run_time.hpp"

using namespace touchstone::vnv::channel;

touchstone::vnv::Case touchstone::vnv::the_case() {
  WorkStudy study = start_up_study(1 * mm);
  study.period = L;
  study.particles.insert(study.particles.end(), {224, 320});
  study.budget = 60;
  study.steps = {2, 1.7, 1.4, 1};
  return error_against_run_time_in<Uniform>(
      "Poiseuille flow in a strip: work-precision diagram",
      "The start-up of plane Poiseuille flow from rest to 1 s, at the paper's bulk modulus, as in poiseuille_run_time; but the "
      "channel, periodic along x, is eight cells long, or as many particles as a kernel reaches over, four to six, instead "
      "of half its height. "
      "Nothing varies along x: the error is the same, and the time to it grows with the square of the resolution instead of "
      "its cube. The larger error of 0.1 and 1 s counts.",
      flow_named("poiseuille"), study);
}
