# Toolchain for a Cortex-M7 with a unit for double precision, without an operating
# system.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-m7)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# Without fused multiplication and addition the numbers are those of a machine without it.
set(CMAKE_CXX_FLAGS_INIT "-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16")
string(APPEND CMAKE_CXX_FLAGS_INIT " -ffp-contract=off"
  " -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections")
