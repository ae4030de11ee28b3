#include "hlg2_tables.h"

namespace lds::catalog::hlg2 {
namespace {

/// Lets a row of the table below name its items in place.
template <ItemId... ids>
inline constexpr std::array<ItemId, sizeof...(ids)> row = {ids...};

using enum ItemId;

// Where the manual's column "Reference page" names several sections or none, the one that describes the
// row's values is given.
constexpr MenuEntry entries[] = {
    {1, QT_TRANSLATE_NOOP("SettingItem", "Bank"), "4.2", row<BankSwitching>},
    {2, QT_TRANSLATE_NOOP("SettingItem", "Sensing"), "4.3"},
    {21, QT_TRANSLATE_NOOP("SettingItem", "Sampling Frequency"), "4.3.1", row<SamplingFrequency>},
    {22, QT_TRANSLATE_NOOP("SettingItem", "Average Times"), "4.3.2", row<AverageTimes>},
    {23, QT_TRANSLATE_NOOP("SettingItem", "Brightness Tuning"), "4.3.3", row<BrightnessTuning>},
    {24, QT_TRANSLATE_NOOP("SettingItem", "Hold Mode"), "4.3.4", row<HoldMode>},
    {25, QT_TRANSLATE_NOOP("SettingItem", "±Inversion"), "4.3.5", row<InversionOfMeasuredValue>},
    {26, QT_TRANSLATE_NOOP("SettingItem", "Span"), "4.3.6", row<Span>},
    {27, QT_TRANSLATE_NOOP("SettingItem", "Offset"), "4.3.7", row<Offset>},
    {3, QT_TRANSLATE_NOOP("SettingItem", "Judgment"), "4.4"},
    {31, QT_TRANSLATE_NOOP("SettingItem", "HIGH Set Value"), "4.4.1", row<HighSetValue>},
    {32, QT_TRANSLATE_NOOP("SettingItem", "LOW Set Value"), "4.4.2", row<LowSetValue>},
    {33, QT_TRANSLATE_NOOP("SettingItem", "Hysteresis"), "4.4.3", row<Hysteresis>},
    {34, QT_TRANSLATE_NOOP("SettingItem", "Teaching Mode"), "4.4.4", row<TeachingMode>},
    {35, QT_TRANSLATE_NOOP("SettingItem", "Tolerance"), "4.4.5", row<Tolerance>},
    {4, QT_TRANSLATE_NOOP("SettingItem", "Output"), "4.5"},
    {42, QT_TRANSLATE_NOOP("SettingItem", "Output Delay Timer"), "4.5"},
    {421, QT_TRANSLATE_NOOP("SettingItem", "Timer Select"), "4.5.1", row<OutputDelayTimerSelection>},
    {422, QT_TRANSLATE_NOOP("SettingItem", "Timer Setting"), "4.5.2", row<OutputDelayTimerSetting>},
    {5, QT_TRANSLATE_NOOP("SettingItem", "Input"), "4.6"},
    {52, QT_TRANSLATE_NOOP("SettingItem", "Laser Stop"), "4.6.1", row<LaserStop>},
    {53, QT_TRANSLATE_NOOP("SettingItem", "Trigger Mode"), "4.6.2", row<TriggerMode>},
    {6, QT_TRANSLATE_NOOP("SettingItem", "Alarm"), "4.7"},
    {62, QT_TRANSLATE_NOOP("SettingItem", "Alarm Digital Output"), "4.7.2", row<AlarmDigitalOutput>},
    {63, QT_TRANSLATE_NOOP("SettingItem", "Alarm Delay Count"), "4.7.1", row<AlarmDelayCount>},
    {7, QT_TRANSLATE_NOOP("SettingItem", "Ethernet"), "5.1"},
    {71, QT_TRANSLATE_NOOP("SettingItem", "IP Address"), "5.2.1",
     row<IpAddress1stOctet, IpAddress2ndOctet, IpAddress3rdOctet, IpAddress4thOctet>},
    {72, QT_TRANSLATE_NOOP("SettingItem", "Subnet Mask"), "5.2.1",
     row<SubnetMask1stOctet, SubnetMask2ndOctet, SubnetMask3rdOctet, SubnetMask4thOctet>},
    {73, QT_TRANSLATE_NOOP("SettingItem", "Default Gateway"), "5.2.1",
     row<DefaultGateway1stOctet, DefaultGateway2ndOctet, DefaultGateway3rdOctet, DefaultGateway4thOctet>},
    {74, QT_TRANSLATE_NOOP("SettingItem", "Port No.(Tool)"), "5.2.1", row<PortTool>},
    {75, QT_TRANSLATE_NOOP("SettingItem", "Port No.(Modbus)"), "5.2.1", row<PortModbus>},
    {76, QT_TRANSLATE_NOOP("SettingItem", "Port No.(SLMP)"), "5.4.1", row<PortSlmp>},
    {77, QT_TRANSLATE_NOOP("SettingItem", "Network No./Node No."), "5.4.1", row<NetworkNumber, NodeNumber>},
    {78, QT_TRANSLATE_NOOP("SettingItem", "MAC Address"), "5.1.1", row<MacAddress>},
    {8, QT_TRANSLATE_NOOP("SettingItem", "RS-485"), "6.1"},
    {81, QT_TRANSLATE_NOOP("SettingItem", "Termination Resistance"), "6.2", row<TerminationResistance>},
    {82, QT_TRANSLATE_NOOP("SettingItem", "Device Address"), "6.2", row<DeviceAddress>},
    {83, QT_TRANSLATE_NOOP("SettingItem", "Comm Speed(bps)"), "6.2", row<CommunicationSpeed>},
    {84, QT_TRANSLATE_NOOP("SettingItem", "Parity/Stop Bit"), "6.2", row<ParityStopBit>},
    {9, QT_TRANSLATE_NOOP("SettingItem", "System"), "4.8"},
    {91, QT_TRANSLATE_NOOP("SettingItem", "Display Digit"), "4.8.1", row<DisplayDigit>},
    {92, QT_TRANSLATE_NOOP("SettingItem", "ECO Mode"), "4.8.2", row<EcoMode>},
    {93, QT_TRANSLATE_NOOP("SettingItem", "Display Inversion"), "4.8.3", row<DisplayInversion>},
    {94, QT_TRANSLATE_NOOP("SettingItem", "Language"), "4.8.4", row<LanguageSetting>},
    {95, QT_TRANSLATE_NOOP("SettingItem", "Comm Reset"), "4.8.5", row<ResettingCommunicationSettings>},
    {96, QT_TRANSLATE_NOOP("SettingItem", "Initialize"), "4.8.6", row<SettingsInitialization>},
};

} // namespace

std::span<const MenuEntry> menu() { return entries; }

} // namespace lds::catalog::hlg2
