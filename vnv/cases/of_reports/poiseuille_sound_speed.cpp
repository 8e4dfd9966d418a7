/// How stiff a fluid has to be: plane Poiseuille flow at sound speeds from a thousand times the largest velocity, which
/// is that of Sun et al., down to the ten times that are usual.

#include "vnv/flows/channels/channel_run_time.hpp"

using namespace touchstone::vnv::channel;

touchstone::vnv::Case touchstone::vnv::the_case() {
  WorkStudy study = start_up_study(1 * mm);
  study.stiffness = stiff_to_soft;
  study.budget = 30;
  return error_against_run_time_in<Uniform>(
      "Poiseuille flow: how stiff must the fluid be?",
      "The start-up of plane Poiseuille flow from rest to 1 s in fluids of several sound speeds c. With K = 143 Pa in "
      "Tait's law, as in Sun et al., c is 1000 times the largest velocity U; the usual factor is ten, with which the "
      "longest acoustic step is a hundred times as long and the fluid ten thousand times as soft. Each method is run "
      "over resolutions, points per cell or smoothing lengths, and time steps at each c; the larger of the errors at "
      "0.1 and 1 s counts.",
      flow_named("poiseuille"), study);
}
