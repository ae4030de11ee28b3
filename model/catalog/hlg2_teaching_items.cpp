#include "hlg2_rows.h"

namespace lds::catalog::hlg2 {
namespace {

constexpr Choice teachingStates[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Not executed")},
                                     {1, QT_TRANSLATE_NOOP("SettingItem", "Being executed")},
                                     {2, QT_TRANSLATE_NOOP("SettingItem", "Success")},
                                     {3, QT_TRANSLATE_NOOP("SettingItem", "Failed")}};

constexpr Choice teachingModes[] = {{1, QT_TRANSLATE_NOOP("SettingItem", "1 point")},
                                    {2, QT_TRANSLATE_NOOP("SettingItem", "2 points")},
                                    {3, QT_TRANSLATE_NOOP("SettingItem", "3 points")}};

constexpr Choice teachingOrders[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Interrupt teaching")},
                                     {1, QT_TRANSLATE_NOOP("SettingItem", "Start teaching")}};

constexpr Choice tuningStates[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Not executed")},
                                   {1, QT_TRANSLATE_NOOP("SettingItem", "1st point being executed")},
                                   {2, QT_TRANSLATE_NOOP("SettingItem", "2nd point being executed")},
                                   {3, QT_TRANSLATE_NOOP("SettingItem", "Success")},
                                   {4, QT_TRANSLATE_NOOP("SettingItem", "Failed")}};

/// Learning from workpieces: brightness tuning (§4.3.3) and teaching (§4.4.4, §4.9).
constexpr SettingItem rows[] = {
    choice({ItemId::BrightnessTuning, "brightnessTuning", 23,
            QT_TRANSLATE_NOOP("SettingItem", "Brightness tuning"), "4.3.3",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "OFF adjusts the laser brightness by itself. ON starts tuning to one bright and one dark "
                "workpiece, which then react faster than in automatic mode. Have both at hand, hold mode "
                "None, and write nothing else until it ends. Tune again when the sampling frequency "
                "changes. Each bank learns for itself; it cannot be copied to another sensor.")},
           bankProcedure, {1, 400126, 125, 2337}, offOn),
    choice({ItemId::TeachingExecutionState, "teachingExecutionState", 0,
            QT_TRANSLATE_NOOP("SettingItem", "Teaching execution state"), "4.9",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "How far teaching is. Success means that HIGH and LOW are new; after Failed they are as "
                "they were.")},
           status, {1, 400133, 132, 2342}, teachingStates),
    choice({ItemId::TeachingMode, "teachingMode", 34, QT_TRANSLATE_NOOP("SettingItem", "Teaching mode"),
            "4.4.4",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "How HIGH and LOW are taught: one master workpiece plus and minus the tolerance, two "
                "workpieces that become the limits themselves, or three with the limits half-way between "
                "them. One value for each bank.")},
           bankSetting, {1, 400134, 133, 2343}, teachingModes, 1),
    choice({ItemId::ExecutionOfTeaching, "executionOfTeaching", 0,
            QT_TRANSLATE_NOOP("SettingItem", "Execution of teaching"), "4.9",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Starts teaching in the chosen mode or breaks it off. It does not start unless hold mode is "
                "None. While it runs the keys are blocked, and nothing else may be written.")},
           procedureStep, {1, 400136, 135, 2344}, teachingOrders),
    trigger({ItemId::Teaching1stPoint, "teaching1stPoint", 0,
             QT_TRANSLATE_NOOP("SettingItem", "Teaching 1st point setting"), "4.9.1",
             QT_TRANSLATE_NOOP(
                 "SettingItem",
                 "Takes the present value as the first workpiece. Teaching has to be started and the value "
                 "has to be steady: in alarm, indeterminate, over range or held it fails.")},
            procedureStep, {1, 400138, 137, 2345}),
    trigger({ItemId::Teaching2ndPoint, "teaching2ndPoint", 0,
             QT_TRANSLATE_NOOP("SettingItem", "Teaching 2nd point setting"), "4.9.2",
             QT_TRANSLATE_NOOP(
                 "SettingItem",
                 "Takes the present value as the second workpiece, in 2 and 3 points teaching. It fails if "
                 "it measures the same as the first.")},
            procedureStep, {1, 400140, 139, 2346}),
    trigger({ItemId::Teaching3rdPoint, "teaching3rdPoint", 0,
             QT_TRANSLATE_NOOP("SettingItem", "Teaching 3rd point setting"), "4.9.3",
             QT_TRANSLATE_NOOP(
                 "SettingItem",
                 "Takes the present value as the third workpiece, in 3 points teaching. It fails if two of "
                 "the three measure the same or the limits come too close for the hysteresis.")},
            procedureStep, {1, 400142, 141, 2347}),
    choice({ItemId::BrightnessTuningExecutionState, "brightnessTuningExecutionState", 0,
            QT_TRANSLATE_NOOP("SettingItem", "Brightness tuning execution state"), "4.3.3",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "How far brightness tuning is and which workpiece it waits for. After Failed, tune both "
                "again.")},
           status, {1, 400144, 143, 2348}, tuningStates),
    trigger({ItemId::BrightnessTuning1stPoint, "brightnessTuning1stPoint", 0,
             QT_TRANSLATE_NOOP("SettingItem", "Brightness tuning 1st point setting"), "4.3.3",
             QT_TRANSLATE_NOOP(
                 "SettingItem",
                 "Tunes to the first workpiece, which has to be in place. Brightness tuning has to be ON "
                 "and waiting for it; an alarm, an indeterminate or a held value makes it fail.")},
            procedureStep, {1, 400146, 145, 2349}),
    trigger({ItemId::BrightnessTuning2ndPoint, "brightnessTuning2ndPoint", 0,
             QT_TRANSLATE_NOOP("SettingItem", "Brightness tuning 2nd point setting"), "4.3.3",
             QT_TRANSLATE_NOOP(
                 "SettingItem",
                 "Tunes to the second workpiece, of clearly different brightness, and ends the tuning. With "
                 "three or more kinds of surface, automatic mode is the better choice.")},
            procedureStep, {1, 400148, 147, 2350}),
};

} // namespace

std::span<const SettingItem> teachingItems() { return rows; }

} // namespace lds::catalog::hlg2
