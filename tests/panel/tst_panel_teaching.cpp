#include "panel_fixture.h"

#include <QTest>

using namespace lds;
using namespace lds::catalog;
using namespace lds::test;
using namespace Qt::StringLiterals;

/// Teaching (§4.9) and brightness tuning (§4.3.3) by the keys.
class TestPanelTeaching : public PanelFixture {
    Q_OBJECT

private:
    /// From the prompt of a target: that it stands there, at `value`.
    void take(Value value)
    {
        place(value);
        tap(Key::Enter);
    }

private Q_SLOTS:
    void init() { setUp(); }

    /// §4.9.1
    void one_point_teaching_shows_success_and_the_new_set_values_in_sequence()
    {
        place(10'000);
        press(Key::Up);
        pass(1999);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        pass(1);
        release(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::Prompt);
        QCOMPARE(shown().title, u"Set Target - Push ENTER SW"_s);
        QCOMPARE(shown().body, u"+1.0000"_s);
        QVERIFY(!m_sensor->isReady());

        tap(Key::Enter);
        QCOMPARE(shown().body, u"Success"_s);
        QCOMPARE(stored(ItemId::HighSetValue), 30'000); // tolerance 2 mm
        QCOMPARE(stored(ItemId::LowSetValue), -10'000);
        QCOMPARE(m_sensor->savedMemory().value(ItemId::HighSetValue), 30'000);
        pass(2000);
        QCOMPARE(shown().title, u"HIGH Set Value"_s);
        QCOMPARE(shown().body, u"+3.0000"_s);
        pass(2000);
        QCOMPARE(shown().title, u"LOW Set Value"_s);
        QCOMPARE(shown().body, u"-1.0000"_s);
        pass(2000);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(m_sensor->isReady());
    }

    /// §4.9.2
    void two_points_teaching_asks_for_both_targets()
    {
        QVERIFY(set(ItemId::TeachingMode, 2));
        holdLong(Key::Up);
        QCOMPARE(shown().title, u"Set 1st Target - Push ENTER SW"_s);
        take(-20'000);
        QCOMPARE(shown().title, u"Set 2nd Target and Push ENTER SW"_s);
        take(20'000);
        QCOMPARE(shown().body, u"Success"_s);
        QCOMPARE(stored(ItemId::HighSetValue), 20'000);
        QCOMPARE(stored(ItemId::LowSetValue), -20'000);
    }

    /// §4.9.3
    void three_points_teaching_asks_for_all_three()
    {
        QVERIFY(set(ItemId::TeachingMode, 3));
        holdLong(Key::Up);
        QCOMPARE(shown().title, u"Set 1st Target - Push ENTER SW"_s);
        take(-20'000);
        QCOMPARE(shown().title, u"Set 2nd Target and Push ENTER SW"_s);
        take(0);
        QCOMPARE(shown().title, u"Set 3rd Target and Push ENTER SW"_s);
        take(40'000);
        QCOMPARE(shown().body, u"Success"_s);
        QCOMPARE(stored(ItemId::HighSetValue), 20'000);
        QCOMPARE(stored(ItemId::LowSetValue), -10'000);
    }

    /// §4.9.2 step 7: "if the 1st and 2nd points have the same measured value, "Failed" will be displayed."
    void teaching_that_fails_says_so_and_changes_nothing()
    {
        QVERIFY(set(ItemId::TeachingMode, 2));
        holdLong(Key::Up);
        take(20'000);
        take(20'000);
        QCOMPARE(shown().body, u"Failed"_s);
        QCOMPARE(stored(ItemId::HighSetValue), 50'000);
        pass(2000);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    /// §4.9.1 step 5: "If the measured value is in an alarm state, etc., "Failed" is displayed"
    void teaching_fails_in_an_alarm()
    {
        holdLong(Key::Up);
        m_sensor->setLight(emulator::Light::Insufficient);
        pass(200);
        tap(Key::Enter);
        QCOMPARE(shown().body, u"Failed"_s);
    }

    /// §4.9: "teaching cannot be started: Hold mode is set to other than None"
    void teaching_does_not_start_with_a_hold_mode()
    {
        QVERIFY(set(ItemId::HoldMode, 2));
        holdLong(Key::Up);
        QCOMPARE(shown().body, u"Error"_s);
        QCOMPARE(m_sensor->teaching().state(), emulator::TeachingState::NotExecuted);
        pass(2000);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    void a_long_enter_breaks_teaching_off()
    {
        QVERIFY(set(ItemId::TeachingMode, 2));
        holdLong(Key::Up);
        take(-20'000);
        holdLong(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QCOMPARE(m_sensor->teaching().state(), emulator::TeachingState::NotExecuted);
        QCOMPARE(stored(ItemId::HighSetValue), 50'000);
    }

    /// §4.8.1: the display digit "does not apply to the measured values displayed during teaching, HIGH set
    /// value / LOW set value"
    void the_display_digit_does_not_count_during_teaching()
    {
        QVERIFY(set(ItemId::DisplayDigit, 3));
        place(12'345);
        QCOMPARE(shown().body, u"+1.2"_s);
        holdLong(Key::Up);
        QCOMPARE(shown().body, u"+1.2345"_s);
        holdLong(Key::Enter);
        tap(Key::Up);
        QCOMPARE(shown().body, u"+5.0000"_s);
    }

    /// §4.9: "Screen transition by operating switches on this product is not possible during the execution of
    /// teaching using communication commands."
    void the_keys_do_nothing_while_teaching_runs_by_communication()
    {
        QVERIFY(set(ItemId::ExecutionOfTeaching, 1));
        for (const Key key : {Key::Up, Key::Enter, Key::Down}) {
            tap(key);
            holdLong(key);
        }
        tapTogether(Key::Up, Key::Down);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(m_sensor->isReady());
        QVERIFY(!shown().icons.zero);
        QVERIFY(set(ItemId::Teaching1stPoint, 0));
        tap(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::WindowValue);
    }

    // Brightness tuning (§4.3.3)

    void tuning_asks_for_two_targets_and_says_success()
    {
        QVERIFY(openMenu(23));
        QCOMPARE(shown().body, u"OFF"_s);
        tap(Key::Down);
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Prompt);
        QCOMPARE(shown().title, u"Set 1st Target - Push ENTER SW"_s);
        tap(Key::Enter);
        QCOMPARE(shown().body, u"Adjusting"_s);
        tap(Key::Enter); // means nothing meanwhile
        QCOMPARE(shown().body, u"Adjusting"_s);
        pass(1500);
        QCOMPARE(shown().title, u"Set 2nd Target and Push ENTER SW"_s);
        tap(Key::Enter);
        QCOMPARE(shown().body, u"Adjusting"_s);
        for (int i = 0; i < 20 && shown().body == u"Adjusting"_s; ++i)
            pass(100);
        QCOMPARE(shown().body, u"Success"_s);
        QCOMPARE(stored(ItemId::BrightnessTuning), 1);
        pass(2000);
        QCOMPARE(shown().menuNumber, 23);
        QCOMPARE(shown().screen, ScreenKind::Menu);
    }

    void tuning_fails_in_an_alarm()
    {
        QVERIFY(openMenu(23));
        tap(Key::Down);
        tap(Key::Enter);
        m_sensor->setLight(emulator::Light::Insufficient);
        pass(200);
        tap(Key::Enter);
        for (int i = 0; i < 30 && shown().body != u"Failed"_s; ++i)
            pass(100);
        QCOMPARE(shown().body, u"Failed"_s);
        QCOMPARE(stored(ItemId::BrightnessTuning), 0);
        pass(2000);
        QCOMPARE(shown().menuNumber, 23);
    }

    void tuning_does_not_start_with_a_hold_mode()
    {
        QVERIFY(set(ItemId::HoldMode, 1));
        QVERIFY(openMenu(23));
        tap(Key::Down);
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Choice);
        QCOMPARE(shown().note, u"Error"_s);
        QCOMPARE(stored(ItemId::BrightnessTuning), 0);
    }

    void a_long_enter_breaks_tuning_off()
    {
        QVERIFY(openMenu(23));
        tap(Key::Down);
        tap(Key::Enter);
        holdLong(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QCOMPARE(m_sensor->tuning().state(), emulator::TuningState::NotExecuted);
        QCOMPARE(stored(ItemId::BrightnessTuning), 0);
    }

    /// §4.3.3: as with teaching.
    void the_keys_do_nothing_while_tuning_runs_by_communication()
    {
        QVERIFY(set(ItemId::BrightnessTuning, 1));
        holdLong(Key::Enter);
        tap(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(set(ItemId::BrightnessTuning, 0));
        holdLong(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Menu);
    }

    /// A power cycle in the middle leaves neither screen nor procedure behind.
    void a_power_cycle_ends_teaching()
    {
        holdLong(Key::Up);
        m_sensor->powerCycle();
        pass(2000);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QCOMPARE(m_sensor->teaching().state(), emulator::TeachingState::NotExecuted);
    }
};

QTEST_GUILESS_MAIN(TestPanelTeaching)
#include "tst_panel_teaching.moc"
