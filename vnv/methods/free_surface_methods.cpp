#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv {

TOUCHSTONE_FREE_SURFACE_METHODS(template, Scene<Tait>)
TOUCHSTONE_FREE_SURFACE_METHODS(template, Scene<Tait, Uniform>)
TOUCHSTONE_FREE_SURFACE_METHODS(template, Scene<Newtonian, Uniform>)

}  // namespace touchstone::vnv
