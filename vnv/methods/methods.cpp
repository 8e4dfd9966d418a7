#include "vnv/methods/methods.hpp"

namespace touchstone::vnv {

TOUCHSTONE_METHODS(template, Scene<Newtonian>)

}  // namespace touchstone::vnv
