#pragma once

// The addresses and menu numbers of the HL-G2 as the manual prints them, transcribed from it and not from the
// catalog: a slip in either shows. Do not "fix" a row here to match the catalog; look into the manual.

namespace manual {

struct Address {
    int number;         ///< Register, device or attribute.
    const char* key;    ///< The catalog's key for the row.
    const char* name;   ///< Column "Data item".
    const char* access; ///< "R", "W", "RW"; EtherNet/IP's Get and Set.
    int size;           ///< Bytes.
};

/// §5.2.4, and the same in §6.3.3.
inline constexpr Address modbus[] = {
    {400011, "sensorState", "Sensor state", "R", 2},
    {400012, "selfMonitoringNotification", "Self-monitoring detail: Notification", "R", 2},
    {400013, "selfMonitoringCaution", "Self-monitoring detail: Caution", "R", 2},
    {400014, "selfMonitoringError", "Self-monitoring detail: Error", "R", 2},
    {400015, "errorCode", "Error code", "R", 2},
    {400020, "measuredValue", "Measured value", "R", 4},
    {400022, "peakIntensity", "Peak intensity of received light", "R", 2},
    {400052, "zeroSetting", "Zero setting", "RW", 1},
    {400054, "setValueSaving", "Set value saving", "W", 1},
    {400056, "measuredValueResetting", "Measured value resetting", "W", 1},
    {400058, "bankSwitching", "Bank switching", "RW", 1},
    {400060, "bankCopy", "Bank copy", "W", 1},
    {400062, "settingsInitialization", "Settings initialization", "W", 1},
    {400071, "languageSetting", "Language setting", "RW", 1},
    {400101, "highSetValue", "HIGH set value", "RW", 4},
    {400103, "lowSetValue", "LOW set value", "RW", 4},
    {400105, "hysteresis", "Hysteresis", "RW", 4},
    {400108, "keyLock", "Key lock", "RW", 1},
    {400109, "ecoMode", "Eco mode", "RW", 1},
    {400110, "alarmDelayCount", "Alarm delay count", "RW", 2},
    {400111, "displayDigit", "Display Digit", "RW", 1},
    {400112, "displayInversion", "Display Inversion", "RW", 1},
    {400113, "samplingFrequency", "Sampling Frequency", "RW", 2},
    {400114, "averageTimes", "Average Times", "RW", 2},
    {400115, "holdMode", "Hold mode", "RW", 2},
    {400116, "span", "Span", "RW", 4},
    {400118, "offset", "Offset", "RW", 4},
    {400120, "tolerance", "Tolerance", "RW", 4},
    {400122, "outputDelayTimerSelection", "Output delay timer selection", "RW", 1},
    {400123, "outputDelayTimerSetting", "Output Delay Timer Setting", "RW", 2},
    {400124, "inversionOfMeasuredValue", "Inversion of Measured Value", "RW", 1},
    {400125, "alarmDigitalOutput", "Alarm digital output", "RW", 1},
    {400126, "brightnessTuning", "Brightness Tuning", "RW", 1},
    {400128, "triggerInputExternal", "Trigger input (external input)", "R", 1},
    {400129, "holdState", "Hold state", "R", 1},
    {400130, "triggerMode", "Trigger mode", "RW", 1},
    {400131, "triggerInputCommunication", "Trigger input (communication)", "RW", 1},
    {400133, "teachingExecutionState", "Teaching execution state", "R", 1},
    {400134, "teachingMode", "Teaching Mode", "RW", 1},
    {400136, "executionOfTeaching", "Execution of teaching", "W", 1},
    {400138, "teaching1stPoint", "Teaching 1st point setting", "W", 1},
    {400140, "teaching2ndPoint", "Teaching 2nd point setting", "W", 1},
    {400142, "teaching3rdPoint", "Teaching 3rd point setting", "W", 1},
    {400144, "brightnessTuningExecutionState", "Brightness Tuning execution state", "R", 1},
    {400146, "brightnessTuning1stPoint", "Brightness Tuning 1st point setting", "W", 1},
    {400148, "brightnessTuning2ndPoint", "Brightness Tuning 2nd point setting", "W", 1},
    {400150, "laserStop", "Laser Stop", "RW", 1},
    {400153, "portModbus", "Port No. (Modbus)", "RW", 2},
    {400154, "portTool", "Port No. (tool)", "RW", 2},
    {400155, "ipAddress4thOctet", "IP Address (4th octet)", "RW", 1},
    {400156, "ipAddress3rdOctet", "IP Address (3rd octet)", "RW", 1},
    {400157, "ipAddress2ndOctet", "IP Address (2nd octet)", "RW", 1},
    {400158, "ipAddress1stOctet", "IP Address (1st octet)", "RW", 1},
    {400159, "subnetMask4thOctet", "Subnet Mask (4th octet)", "RW", 1},
    {400160, "subnetMask3rdOctet", "Subnet Mask (3rd octet)", "RW", 1},
    {400161, "subnetMask2ndOctet", "Subnet Mask (2nd octet)", "RW", 1},
    {400162, "subnetMask1stOctet", "Subnet Mask (1st octet)", "RW", 1},
    {400163, "defaultGateway4thOctet", "Default Gateway (4th octet)", "RW", 1},
    {400164, "defaultGateway3rdOctet", "Default Gateway (3rd octet)", "RW", 1},
    {400165, "defaultGateway2ndOctet", "Default Gateway (2nd octet)", "RW", 1},
    {400166, "defaultGateway1stOctet", "Default Gateway (1st octet)", "RW", 1},
    {400167, "communicationSpeed", "Communication speed", "RW", 1},
    {400168, "parityStopBit", "Parity/Stop Bit", "RW", 1},
    {400169, "deviceAddress", "Device Address", "RW", 1},
    {400170, "terminationResistance", "Termination resistance", "RW", 1},
    {400171, "resettingCommunicationSettings", "Resetting communication settings", "W", 1},
};

/// §5.4.4. Device 128 is printed "Hold mode"; its description makes it the hold state.
inline constexpr Address slmp[] = {
    {10, "sensorState", "Sensor state", "R", 2},
    {11, "selfMonitoringNotification", "Self-monitoring detail: Notification", "R", 2},
    {12, "selfMonitoringCaution", "Self-monitoring detail: Caution", "R", 2},
    {13, "selfMonitoringError", "Self-monitoring detail: Error", "R", 2},
    {14, "errorCode", "Error code", "R", 2},
    {19, "measuredValue", "Measured value", "R", 4},
    {21, "peakIntensity", "Peak intensity of received light", "R", 2},
    {51, "zeroSetting", "Zero Setting", "RW", 1},
    {53, "setValueSaving", "Set value saving", "W", 1},
    {55, "measuredValueResetting", "Measured value resetting", "W", 1},
    {57, "bankSwitching", "Bank switching", "RW", 1},
    {59, "bankCopy", "Bank copy", "W", 1},
    {61, "settingsInitialization", "Settings initialization", "W", 1},
    {70, "languageSetting", "Language setting", "RW", 1},
    {100, "highSetValue", "HIGH set value", "RW", 4},
    {102, "lowSetValue", "LOW set value", "RW", 4},
    {104, "hysteresis", "Hysteresis", "RW", 4},
    {107, "keyLock", "Key lock", "RW", 1},
    {108, "ecoMode", "Eco mode", "RW", 1},
    {109, "alarmDelayCount", "Alarm delay count", "RW", 2},
    {110, "displayDigit", "Display Digit", "RW", 1},
    {111, "displayInversion", "Display Inversion", "RW", 1},
    {112, "samplingFrequency", "Sampling Frequency", "RW", 2},
    {113, "averageTimes", "Average Times", "RW", 2},
    {114, "holdMode", "Hold mode", "RW", 2},
    {115, "span", "Span", "RW", 4},
    {117, "offset", "Offset", "RW", 4},
    {119, "tolerance", "Tolerance", "RW", 4},
    {121, "outputDelayTimerSelection", "Output delay timer selection", "RW", 1},
    {122, "outputDelayTimerSetting", "Output Delay Timer Setting", "RW", 2},
    {123, "inversionOfMeasuredValue", "Inversion of Measured Value", "RW", 1},
    {124, "alarmDigitalOutput", "Alarm digital output", "RW", 1},
    {125, "brightnessTuning", "Brightness Tuning", "RW", 1},
    {127, "triggerInputExternal", "Trigger input (external input)", "R", 1},
    {128, "holdState", "Hold mode", "R", 1},
    {129, "triggerMode", "Trigger mode", "RW", 1},
    {130, "triggerInputCommunication", "Trigger input (communication)", "RW", 1},
    {132, "teachingExecutionState", "Teaching execution state", "R", 1},
    {133, "teachingMode", "Teaching Mode", "RW", 1},
    {135, "executionOfTeaching", "Execution of teaching", "W", 1},
    {137, "teaching1stPoint", "Teaching 1st point setting", "W", 1},
    {139, "teaching2ndPoint", "Teaching 2nd point setting", "W", 1},
    {141, "teaching3rdPoint", "Teaching 3rd point setting", "W", 1},
    {143, "brightnessTuningExecutionState", "Brightness Tuning execution state", "R", 1},
    {145, "brightnessTuning1stPoint", "Brightness Tuning 1st point setting", "W", 1},
    {147, "brightnessTuning2ndPoint", "Brightness Tuning 2nd point setting", "W", 1},
    {149, "laserStop", "Laser Stop", "RW", 1},
    {170, "resettingCommunicationSettings", "Resetting communication settings", "W", 2},
};

/// §5.3.5, in the printed order.
inline constexpr Address etherNetIp[] = {
    {2304, "sensorState", "Sensor state", "R", 2},
    {2305, "selfMonitoringNotification", "Self-monitoring detail: Notification", "R", 2},
    {2306, "selfMonitoringCaution", "Self-monitoring detail: Caution", "R", 2},
    {2307, "selfMonitoringError", "Self-monitoring detail: Error", "R", 2},
    {2308, "errorCode", "Error code", "R", 2},
    {2311, "measuredValue", "Measured value", "R", 4},
    {2312, "zeroSetting", "Zero Setting", "RW", 1},
    {2313, "setValueSaving", "Set value saving", "W", 1},
    {2314, "measuredValueResetting", "Measured value resetting", "W", 1},
    {2315, "bankSwitching", "Bank switching", "RW", 1},
    {2316, "bankCopy", "Bank copy", "W", 1},
    {2317, "settingsInitialization", "Settings initialization", "W", 1},
    {2321, "languageSetting", "Language setting", "RW", 1},
    {2318, "highSetValue", "HIGH set value", "RW", 4},
    {2319, "lowSetValue", "LOW set value", "RW", 4},
    {2320, "hysteresis", "Hysteresis", "RW", 4},
    {2322, "keyLock", "Key lock", "RW", 1},
    {2323, "ecoMode", "Eco mode", "RW", 1},
    {2324, "alarmDelayCount", "Alarm delay count", "RW", 2},
    {2325, "displayDigit", "Display Digit", "RW", 1},
    {2326, "displayInversion", "Display Inversion", "RW", 1},
    {2327, "samplingFrequency", "Sampling Frequency", "RW", 2},
    {2328, "averageTimes", "Average Times", "RW", 2},
    {2329, "holdMode", "Hold mode", "RW", 2},
    {2330, "span", "Span", "RW", 4},
    {2331, "offset", "Offset", "RW", 4},
    {2332, "tolerance", "Tolerance", "RW", 4},
    {2333, "outputDelayTimerSelection", "Output delay timer selection", "RW", 1},
    {2334, "outputDelayTimerSetting", "Output delay timer setting", "RW", 2},
    {2335, "inversionOfMeasuredValue", "Inversion of Measured Value", "RW", 1},
    {2336, "alarmDigitalOutput", "Alarm digital output", "RW", 1},
    {2337, "brightnessTuning", "Brightness Tuning", "RW", 1},
    {2338, "triggerInputExternal", "Trigger input (external input)", "R", 1},
    {2339, "holdState", "Hold state", "R", 1},
    {2340, "triggerMode", "Trigger mode", "RW", 1},
    {2341, "triggerInputCommunication", "Trigger input (communication)", "RW", 1},
    {2342, "teachingExecutionState", "Teaching execution state", "R", 1},
    {2343, "teachingMode", "Teaching Mode", "RW", 1},
    {2344, "executionOfTeaching", "Execution of teaching", "W", 1},
    {2345, "teaching1stPoint", "Teaching 1st point setting", "W", 1},
    {2346, "teaching2ndPoint", "Teaching 2nd point setting", "W", 1},
    {2347, "teaching3rdPoint", "Teaching 3rd point setting", "W", 1},
    {2348, "brightnessTuningExecutionState", "Brightness Tuning execution state", "R", 1},
    {2349, "brightnessTuning1stPoint", "Brightness Tuning 1st point setting", "W", 1},
    {2350, "brightnessTuning2ndPoint", "Brightness Tuning 2nd point setting", "W", 1},
    {2351, "laserStop", "Laser Stop", "RW", 1},
};

/// "Usage prohibited" in §5.2.4.
inline constexpr int usageProhibited[] = {400051, 400053, 400055, 400057, 400059, 400061, 400063,
                                          400127, 400132, 400135, 400137, 400139, 400141, 400143,
                                          400145, 400147, 400149, 400151, 400172};

struct Menu {
    int number;
    int bars; ///< Column "Hierarchical level display bar".
    const char* name;
    const char* section;
    const char* keys; ///< What the row sets, space separated; empty for a heading.
};

#define OCTETS(group) group "1stOctet " group "2ndOctet " group "3rdOctet " group "4thOctet"

/// §2.2, in the printed order.
inline constexpr Menu menu[] = {
    {1, 1, "Bank", "4.2", "bankSwitching"},
    {2, 1, "Sensing", "4.3", ""},
    {3, 1, "Judgment", "4.4", ""},
    {4, 1, "Output", "4.5", ""},
    {5, 1, "Input", "4.6", ""},
    {6, 1, "Alarm", "4.7", ""},
    {7, 1, "Ethernet", "5.1", ""},
    {8, 1, "RS-485", "6.1", ""},
    {9, 1, "System", "4.8", ""},
    {21, 2, "Sampling Frequency", "4.3.1", "samplingFrequency"},
    {22, 2, "Average Times", "4.3.2", "averageTimes"},
    {23, 2, "Brightness Tuning", "4.3.3", "brightnessTuning"},
    {24, 2, "Hold Mode", "4.3.4", "holdMode"},
    {25, 2, "±Inversion", "4.3.5", "inversionOfMeasuredValue"},
    {26, 2, "Span", "4.3.6", "span"},
    {27, 2, "Offset", "4.3.7", "offset"},
    {31, 2, "HIGH Set Value", "4.4.1", "highSetValue"},
    {32, 2, "LOW Set Value", "4.4.2", "lowSetValue"},
    {33, 2, "Hysteresis", "4.4.3", "hysteresis"},
    {34, 2, "Teaching Mode", "4.4.4", "teachingMode"},
    {35, 2, "Tolerance", "4.4.5", "tolerance"},
    {42, 2, "Output Delay Timer", "4.5", ""}, // No section printed; it is a heading within 4.5.
    {52, 2, "Laser Stop", "4.6.1", "laserStop"},
    {53, 2, "Trigger Mode", "4.6.2", "triggerMode"},
    {62, 2, "Alarm Digital Output", "4.7.2", "alarmDigitalOutput"},
    {63, 2, "Alarm Delay Count", "4.7.1", "alarmDelayCount"},
    {71, 2, "IP Address", "5.2.1", OCTETS("ipAddress")},
    {72, 2, "Subnet Mask", "5.2.1", OCTETS("subnetMask")},
    {73, 2, "Default Gateway", "5.2.1", OCTETS("defaultGateway")},
    {74, 2, "Port No.(Tool)", "5.2.1", "portTool"},
    {75, 2, "Port No.(Modbus)", "5.2.1", "portModbus"},
    {76, 2, "Port No.(SLMP)", "5.4.1", "portSlmp"},
    {77, 2, "Network No./Node No.", "5.4.1", "networkNumber nodeNumber"},
    {78, 2, "MAC Address", "5.1.1", "macAddress"}, // Only the note of 5.1.1 speaks of it.
    {81, 2, "Termination Resistance", "6.2", "terminationResistance"},
    {82, 2, "Device Address", "6.2", "deviceAddress"},
    {83, 2, "Comm Speed(bps)", "6.2", "communicationSpeed"},
    {84, 2, "Parity/Stop Bit", "6.2", "parityStopBit"},
    {91, 2, "Display Digit", "4.8.1", "displayDigit"},
    {92, 2, "ECO Mode", "4.8.2", "ecoMode"},
    {93, 2, "Display Inversion", "4.8.3", "displayInversion"},
    {94, 2, "Language", "4.8.4", "languageSetting"},
    {95, 2, "Comm Reset", "4.8.5", "resettingCommunicationSettings"},
    {96, 2, "Initialize", "4.8.6", "settingsInitialization"},
    {421, 3, "Timer Select", "4.5.1", "outputDelayTimerSelection"},
    {422, 3, "Timer Setting", "4.5.2", "outputDelayTimerSetting"},
};

#undef OCTETS

struct Coil {
    int number;
    const char* name;
};

/// §5.2.5; all others of the 64 are reserved.
inline constexpr Coil coils[] = {
    {1, "Alarm state"},
    {2, "Data in an indeterminate state"},
    {3, "Judgment output state (HI)"},
    {4, "Judgment output state (GO)"},
    {5, "Judgment output state (LO)"},
    {6, "Judgment output state at timer OFF (HI)"},
    {7, "Judgment output state at timer OFF (GO)"},
    {8, "Judgment output state at timer OFF (LO)"},
    {9, "Hold state"},
    {10, "Zero setting state"},
    {11, "Laser state"},
    {12, "Self-monitoring: Error"},
    {13, "Self-monitoring: Caution"},
    {14, "Self-monitoring: Notification"},
    {17, "Excessive intensity of received light"},
    {18, "Insufficient intensity of received light"},
    {19, "Outside the measurement range"},
    {20, "Excessive extraneous light"},
    {33, "Cumulative operation hours exceeded"},
    {34, "Number of writes to internal memory exceeded"},
    {49, "Beam-emitting circuit error"},
    {51, "System error"},
};

} // namespace manual
