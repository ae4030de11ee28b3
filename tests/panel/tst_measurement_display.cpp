#include "panel_fixture.h"

#include <QTest>

using namespace lds;
using namespace lds::catalog;
using namespace lds::test;
using namespace Qt::StringLiterals;

/// The measurement display (§2.2) and what is looked at and entered from it (§4.1, §4.4.1, §4.4.2).
class TestMeasurementDisplay : public PanelFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void the_measured_value_is_shown_in_mm_with_its_sign()
    {
        place(12'345);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QCOMPARE(shown().body, u"+1.2345"_s);
        QCOMPARE(shown().unit, u"mm"_s);
        place(-12'345);
        QCOMPARE(shown().body, u"-1.2345"_s);
    }

    void the_display_follows_the_sensor_within_a_tenth_of_a_second()
    {
        m_sensor->placeWorkpiece(20'000);
        QCOMPARE(shown().body, u"+0.0000"_s);
        pass(100);
        QCOMPARE(shown().body, u"+2.0000"_s);
    }

    /// §4.8.1: "Any numbers after the specified number of digits displayed are rounded down."
    void digits_that_are_not_displayed_are_cut_off_data()
    {
        QTest::addColumn<SensorModel>("model");
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("30 mm, 4 digits") << SensorModel::HlG203 << 0 << 19'999 << u"+1.9999"_s;
        QTest::newRow("30 mm, 3 digits") << SensorModel::HlG203 << 1 << 19'999 << u"+1.999"_s;
        QTest::newRow("30 mm, 2 digits") << SensorModel::HlG203 << 2 << 19'999 << u"+1.99"_s;
        QTest::newRow("30 mm, 1 digit") << SensorModel::HlG203 << 3 << -19'999 << u"-1.9"_s;
        QTest::newRow("50 mm, 3 digits") << SensorModel::HlG205 << 1 << 19'999 << u"+1.999"_s;
        QTest::newRow("50 mm, 0 digits") << SensorModel::HlG205 << 4 << 99'999 << u"+9"_s;
        QTest::newRow("250 mm, 2 digits") << SensorModel::HlG225 << 2 << -1'234'567 << u"-123.45"_s;
        QTest::newRow("nothing is left") << SensorModel::HlG203 << 3 << -999 << u"+0.0"_s;
    }
    void digits_that_are_not_displayed_are_cut_off()
    {
        QFETCH(SensorModel, model);
        QFETCH(int, code);
        QFETCH(int, value);
        QFETCH(QString, text);
        setUp(model);
        QVERIFY(set(ItemId::DisplayDigit, code));
        place(value);
        QCOMPARE(shown().body, text);
    }

    /// §2.2 note.
    void beyond_the_display_range_it_says_over()
    {
        QVERIFY(set(ItemId::Span, 99'999));
        place(20'000);
        QCOMPARE(shown().body, u"+OVER"_s);
        place(-20'000);
        QCOMPARE(shown().body, u"-OVER"_s);
    }

    /// §2.2 note, §4.3.2.
    void while_indeterminate_it_shows_dashes()
    {
        QVERIFY(set(ItemId::AverageTimes, 6));
        pass(100);
        QCOMPARE(shown().body, u"----"_s);
        pass(1100);
        QCOMPARE(shown().body, u"+0.0000"_s);
    }

    /// §2.2, §4.7.2
    void an_alarm_is_shown_only_when_the_alarm_digital_output_is_alarm()
    {
        place(10'000);
        m_sensor->setLight(emulator::Light::Insufficient);
        pass(200);
        QCOMPARE(shown().body, u"+1.0000"_s); // Hold: the previous measured value
        m_sensor->setLight(emulator::Light::Measurable);
        QVERIFY(set(ItemId::AlarmDigitalOutput, 1));
        pass(100);
        m_sensor->setLight(emulator::Light::Insufficient);
        pass(200);
        QCOMPARE(shown().body, u"ALARM"_s);
    }

    /// §8.2
    void an_error_shows_its_code_with_the_two_internal_digits()
    {
        m_sensor->raiseError({200, 7});
        pass(100);
        QCOMPARE(shown().body, u"E20007"_s);
        QCOMPARE(shown().unit, QString());
    }

    /// §2.2, icons 2 to 7.
    void the_icons_show_the_state_of_the_measurement()
    {
        QVERIFY(shown().icons.laser);
        QVERIFY(shown().icons.go);
        QCOMPARE(shown().icons.bank, u"B1"_s);
        QCOMPARE(shown().icons.holdMode, QString());
        QVERIFY(!shown().icons.hold && !shown().icons.zero && !shown().icons.high && !shown().icons.low);

        place(60'000);
        QVERIFY(shown().icons.high && !shown().icons.go);
        place(-60'000);
        QVERIFY(shown().icons.low && !shown().icons.high);

        QVERIFY(set(ItemId::TriggerInputCommunication, 1));
        pass(100);
        QVERIFY(shown().icons.hold);
        QVERIFY(set(ItemId::TriggerInputCommunication, 0));
        QVERIFY(set(ItemId::ZeroSetting, 1));
        pass(100);
        QVERIFY(shown().icons.zero && !shown().icons.hold);

        for (const auto& [code, text] : {std::pair(1, u"P"_s), {2, u"B"_s}, {3, u"PP"_s}, {0, QString()}}) {
            QVERIFY(set(ItemId::HoldMode, code));
            pass(100);
            QCOMPARE(shown().icons.holdMode, text);
        }
        QVERIFY(set(ItemId::BankSwitching, 3));
        QVERIFY(set(ItemId::LaserStop, 1));
        pass(100);
        QCOMPARE(shown().icons.bank, u"B3"_s);
        QVERIFY(!shown().icons.laser);
    }

    /// §4.5.1: the output delay timer delays the judgment result.
    void the_judgment_icons_follow_the_output_delay_timer()
    {
        QVERIFY(set(ItemId::AverageTimes, 0));
        QVERIFY(set(ItemId::OutputDelayTimerSelection, 2));
        QVERIFY(set(ItemId::OutputDelayTimerSetting, 100));
        pass(500);
        QVERIFY(shown().icons.go);
        m_sensor->placeWorkpiece(60'000);
        pass(50);
        const auto measured = m_sensor->measured();
        QCOMPARE(measured.judgment, emulator::Judgment::High);
        press(Key::Down); // redraws
        QVERIFY(shown().icons.go);
        pass(200);
        QVERIFY(!shown().icons.go && shown().icons.high);
    }

    /// §2.2, sensor unit.
    void the_indicators_tell_of_laser_alarm_and_error()
    {
        QCOMPARE(shown().laserIndicator, IndicatorState::Lit);
        QCOMPARE(shown().alarmIndicator, IndicatorState::Off);
        m_sensor->setLight(emulator::Light::Excessive);
        pass(200);
        QCOMPARE(shown().alarmIndicator, IndicatorState::Lit);
        m_sensor->setLight(emulator::Light::Measurable);
        QVERIFY(set(ItemId::LaserStop, 1));
        pass(200);
        QCOMPARE(shown().laserIndicator, IndicatorState::Off);
        QCOMPARE(shown().alarmIndicator, IndicatorState::Off);
        m_sensor->raiseError({120, 0});
        pass(100);
        QCOMPARE(shown().laserIndicator, IndicatorState::Blinking);
        QCOMPARE(shown().alarmIndicator, IndicatorState::Blinking);
    }

    /// §4.1 "Received light intensity monitor"
    void enter_shows_the_received_light_and_enter_leaves_it()
    {
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::ReceivedLight);
        QCOMPARE(shown().title, u"Received light"_s);
        bool isNumber = false;
        const int intensity = shown().body.toInt(&isNumber);
        QVERIFY2(isNumber && intensity > 0 && intensity <= 1023, qPrintable(shown().body));
        QVERIFY(m_sensor->isReady());
        QVERIFY(set(ItemId::AverageTimes, 6));
        pass(100);
        QCOMPARE(shown().body, u"----"_s);
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    /// §4.4.1, §4.4.2: name at the top, set value below.
    void up_and_down_show_the_high_and_low_set_values()
    {
        tap(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::WindowValue);
        QCOMPARE(shown().title, u"HIGH Set Value"_s);
        QCOMPARE(shown().body, u"+5.0000"_s);
        QCOMPARE(shown().edited, -1);
        tap(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        tap(Key::Down);
        QCOMPARE(shown().title, u"LOW Set Value"_s);
        QCOMPARE(shown().body, u"-5.0000"_s);
        holdLong(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    /// §4.4.2: "pressing the ENTER key at the last digit determines the change"
    void a_set_value_is_changed_digit_by_digit_from_the_measurement_display()
    {
        tap(Key::Up);
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Entry);
        QCOMPARE(shown().title, u"HIGH Set Value"_s);
        QCOMPARE(shown().body, u"+5.0000"_s);
        QCOMPARE(shown().edited, 0); // the sign
        QCOMPARE(shown().menuNumber, 0);
        tap(Key::Enter);
        QCOMPARE(shown().edited, 1);
        tap(Key::Down, 2);
        QCOMPARE(shown().body, u"+3.0000"_s);
        tap(Key::Enter);
        QCOMPARE(shown().edited, 3); // over the point
        tap(Key::Enter, 3);
        QCOMPARE(shown().edited, 6);
        tap(Key::Up, 2);
        QCOMPARE(stored(ItemId::HighSetValue), 50'000);
        tap(Key::Enter);
        QCOMPARE(stored(ItemId::HighSetValue), 30'002);
        QCOMPARE(m_sensor->savedMemory().value(ItemId::HighSetValue), 30'002);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    /// §5.2.2: commands are for the measurement display.
    void the_sensor_is_not_ready_while_a_set_value_is_shown()
    {
        QVERIFY(m_sensor->isReady());
        tap(Key::Down);
        QVERIFY(!m_sensor->isReady());
        tap(Key::Down);
        QVERIFY(m_sensor->isReady());
    }
};

QTEST_GUILESS_MAIN(TestMeasurementDisplay)
#include "tst_measurement_display.moc"
