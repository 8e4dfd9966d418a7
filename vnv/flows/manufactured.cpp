#include "vnv/flows/manufactured.hpp"

namespace touchstone::vnv {

TOUCHSTONE_METHODS(template, Scene<Newtonian, manufactured::Sustaining>)

}  // namespace touchstone::vnv
