// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/node/motor_control_node.hpp"
#include "interfaces/runtime/run_component.hpp"

int main(int argc, char** argv) {
  using namespace enfilade::motor_control;
  return enfilade::run_component<MotorControlNode, MotorControlConfig>("motorControl", argc, argv);
}
