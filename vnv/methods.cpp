#include "vnv/methods.hpp"

namespace touchstone::vnv {

TOUCHSTONE_METHODS(template, Scene<Newtonian>)

}  // namespace touchstone::vnv
