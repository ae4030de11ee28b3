#pragma once

// Ranges, defaults and choices of the HL-G2 as chapters 4 to 6 of the manual print them (lengths in mm),
// while the catalog holds the wire units of §5.2.4. Transcribed from the manual and not from the catalog.

namespace manual {

struct Length {
    const char* key;
    const char* type; ///< The five types' numbers in the type name, 203 … 225.
    const char* minimum;
    const char* maximum;
    const char* defaultValue;
};

/// §4.3.7, §4.4.1, §4.4.2, §4.4.3, §4.4.5 in mm; as many decimals as the type resolves.
inline constexpr Length lengths[] = {
    {"offset", "203", "-9.5000", "+9.5000", "0.0000"},
    {"offset", "205", "-95.000", "+95.000", "0.000"},
    {"offset", "208", "-95.000", "+95.000", "0.000"},
    {"offset", "212", "-95.000", "+95.000", "0.000"},
    {"offset", "225", "-950.00", "+950.00", "0.00"},
    {"highSetValue", "203", "-9.5000", "+9.5000", "+5.0000"},
    {"highSetValue", "205", "-95.000", "+95.000", "+10.000"},
    {"highSetValue", "208", "-95.000", "+95.000", "+20.000"},
    {"highSetValue", "212", "-95.000", "+95.000", "+30.000"},
    {"highSetValue", "225", "-950.00", "+950.00", "+150.00"},
    {"lowSetValue", "203", "-9.5000", "+9.5000", "-5.0000"},
    {"lowSetValue", "205", "-95.000", "+95.000", "-10.000"},
    {"lowSetValue", "208", "-95.000", "+95.000", "-20.000"},
    {"lowSetValue", "212", "-95.000", "+95.000", "-30.000"},
    {"lowSetValue", "225", "-950.00", "+950.00", "-150.00"},
    {"hysteresis", "203", "0.0000", "+9.5000", "+0.0100"},
    {"hysteresis", "205", "0.000", "+95.000", "+0.020"},
    {"hysteresis", "208", "0.000", "+95.000", "+0.040"},
    {"hysteresis", "212", "0.000", "+95.000", "+0.060"},
    {"hysteresis", "225", "0.00", "+950.00", "+0.30"},
    {"tolerance", "203", "0.0001", "9.5000", "+2.0000"},
    {"tolerance", "205", "0.001", "95.000", "+5.000"},
    {"tolerance", "208", "0.001", "95.000", "+10.000"},
    {"tolerance", "212", "0.001", "95.000", "+15.000"},
    {"tolerance", "225", "0.01", "950.00", "+100.00"},
};

struct Number {
    const char* key;
    int minimum;
    int maximum;
    int defaultValue;
};

/// The same for every type: §4.3.6 (times 10,000), §4.5.2, §4.7.1, §5.2.1, §5.4.1, §6.2.
inline constexpr Number numbers[] = {
    {"span", 1'000, 99'999, 10'000},
    {"outputDelayTimerSetting", 1, 100, 1},
    {"alarmDelayCount", 0, 65'535, 8},
    {"portTool", 1, 65'535, 49'152},
    {"portModbus", 1, 65'535, 502},
    {"portSlmp", 1, 65'535, 45'237},
    {"networkNumber", 0, 239, 0},
    {"nodeNumber", 1, 255, 255},
    {"ipAddress1stOctet", 0, 255, 192},
    {"ipAddress2ndOctet", 0, 255, 168},
    {"ipAddress3rdOctet", 0, 255, 1},
    {"ipAddress4thOctet", 0, 255, 6},
    {"subnetMask1stOctet", 0, 255, 255},
    {"subnetMask2ndOctet", 0, 255, 255},
    {"subnetMask3rdOctet", 0, 255, 255},
    {"subnetMask4thOctet", 0, 255, 0},
    {"defaultGateway1stOctet", 0, 255, 192},
    {"defaultGateway2ndOctet", 0, 255, 168},
    {"defaultGateway3rdOctet", 0, 255, 1},
    {"defaultGateway4thOctet", 0, 255, 1},
    {"deviceAddress", 1, 247, 1},
};

constexpr int noDefault = -1;

struct Choices {
    const char* key;
    const char* codes; ///< "code=name" joined by "|"; codes of §5.2.4, names of chapter 4 where it has them.
    int defaultCode;
};

/// The same for every type; display digit stands below.
inline constexpr Choices choices[] = {
    {"bankSwitching", "1=Bank 1|2=Bank 2|3=Bank 3|4=Bank 4", 1},
    {"samplingFrequency", "0=100 µs|1=200 µs|2=500 µs|3=1 ms|4=2 ms", 3},
    {"averageTimes", "0=1 time|1=4 times|2=16 times|3=64 times|4=256 times|5=512 times|6=1024 times", 5},
    {"brightnessTuning", "0=OFF|1=ON", 0},
    {"holdMode", "0=None (Normal mode)|1=Peak Hold|2=Bottom Hold|3=Peak to Peak Hold", 0},
    {"inversionOfMeasuredValue", "0=Normal|1=Reverse", 0},
    {"teachingMode", "1=1 point|2=2 points|3=3 points", 1},
    {"outputDelayTimerSelection", "0=OFF (No timer)|1=On Delay|2=Off Delay|3=One Shot|4=Hold", 0},
    {"laserStop", "0=OFF (Laser emitted)|1=ON (Emission stopped)", 0},
    {"triggerMode", "0=Hold|1=One Shot", 0},
    {"alarmDigitalOutput", "0=Hold|1=Alarm", 0},
    {"ecoMode", "0=OFF|1=ON", 1},
    {"displayInversion", "0=Default|1=Inverted", 0},
    {"languageSetting", "0=English|1=Japanese|2=Simplified Chinese", 0},
    {"terminationResistance", "0=OFF|1=ON", 1},
    {"communicationSpeed", "0=9600 bps|1=19200 bps|2=38400 bps|3=115200 bps|4=230400 bps", 2},
    {"parityStopBit", "0=NON + 2bit|1=EVEN + 1bit|2=ODD + 1bit", 1},
    {"zeroSetting", "0=Zero setting OFF|1=Zero setting ON", noDefault},
    {"keyLock", "0=Disable key lock|1=Enable key lock", noDefault},
    {"triggerInputCommunication", "0=OFF|1=ON", noDefault},
    {"triggerInputExternal", "0=OFF|1=ON", noDefault},
    {"holdState", "0=Release|1=Hold", noDefault},
    {"teachingExecutionState", "0=Not executed|1=Being executed|2=Success|3=Failed", noDefault},
    {"executionOfTeaching", "0=Interrupt teaching|1=Start teaching", noDefault},
    {"brightnessTuningExecutionState",
     "0=Not executed|1=1st point being executed|2=2nd point being executed|3=Success|4=Failed", noDefault},
    {"settingsInitialization", "1=Bank 1|2=Bank 2|3=Bank 3|4=Bank 4|5=All Banks|6=All Areas", noDefault},
    {"bankCopy",
     "0=Bank 1 to Bank 2|1=Bank 1 to Bank 3|2=Bank 1 to Bank 4|3=Bank 2 to Bank 1|4=Bank 2 to Bank 3|"
     "5=Bank 2 to Bank 4|6=Bank 3 to Bank 1|7=Bank 3 to Bank 2|8=Bank 3 to Bank 4|9=Bank 4 to Bank 1|"
     "10=Bank 4 to Bank 2|11=Bank 4 to Bank 3",
     noDefault},
};

struct DisplayDigits {
    const char* type;
    const char* codes;
    int defaultCode;
};

/// §4.8.1 and §5.2.4 register 400111.
inline constexpr DisplayDigits displayDigits[] = {
    {"203", "0=4 digits (0.0001)|1=3 digits (0.001)|2=2 digits (0.01)|3=1 digit (0.1)", 0},
    {"205", "1=3 digits (0.001)|2=2 digits (0.01)|3=1 digit (0.1)|4=0 digits (1)", 1},
    {"208", "1=3 digits (0.001)|2=2 digits (0.01)|3=1 digit (0.1)|4=0 digits (1)", 1},
    {"212", "1=3 digits (0.001)|2=2 digits (0.01)|3=1 digit (0.1)|4=0 digits (1)", 1},
    {"225", "2=2 digits (0.01)|3=1 digit (0.1)|4=0 digits (1)", 2},
};

/// §4.2 "Types of setting items read from banks"; the zero set is one item in the protocols.
inline constexpr const char* bankItems[] = {
    "samplingFrequency",
    "averageTimes",
    "brightnessTuning",
    "holdMode",
    "span",
    "offset",
    "highSetValue",
    "lowSetValue",
    "hysteresis",
    "teachingMode",
    "tolerance",
    "outputDelayTimerSelection",
    "outputDelayTimerSetting",
    "triggerMode",
    "alarmDigitalOutput",
    "alarmDelayCount",
    "displayDigit",
    "zeroSetting",
};

struct Type {
    const char* typeName;
    int centerDistanceMm;   ///< §3.3
    int measurementRangeMm; ///< ± around it, §4.13
    const char* displayLimitMm;
    int decimals;
};

inline constexpr Type types[] = {
    {"HL-G203B-S-MK", 30, 5, "9.5000", 4},    {"HL-G205B-S-MK", 50, 10, "95.000", 3},
    {"HL-G208B-S-MK", 85, 20, "95.000", 3},   {"HL-G212B-S-MK", 120, 30, "95.000", 3},
    {"HL-G225B-S-MK", 250, 150, "950.00", 2},
};

} // namespace manual
