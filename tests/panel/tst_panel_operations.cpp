#include "panel_fixture.h"

#include <QTest>

using namespace lds;
using namespace lds::catalog;
using namespace lds::test;
using namespace Qt::StringLiterals;
using emulator::FrontPanel;

/// What the keys do on the measurement display beside showing (§4.10, §4.11, §4.12), what the display does by
/// itself (§4.8.2, §4.8.3, §4.8.4), and what happens at power-on (§3.6, §4.8.6).
class TestPanelOperations : public PanelFixture {
    Q_OBJECT

private:
    static constexpr int ecoMs = int(FrontPanel::untilEcoMs);

private Q_SLOTS:
    void init() { setUp(); }

    // Zero setting, resetting

    /// §4.10
    void up_and_down_together_set_zero()
    {
        place(12'345);
        tapTogether(Key::Up, Key::Down);
        QCOMPARE(shown().body, u"+0.0000"_s);
        QVERIFY(shown().icons.zero);
        QCOMPARE(m_sensor->savedMemory().value(ItemId::ZeroSetting), 1);
        QCOMPARE(stored(ItemId::KeyLock), 0);
    }

    /// §4.10
    void down_and_enter_together_clear_the_zero_setting()
    {
        place(12'345);
        tapTogether(Key::Up, Key::Down);
        press(Key::Down);
        press(Key::Enter);
        QCOMPARE(shown().body, u"+1.2345"_s);
        QVERIFY(!shown().icons.zero);
        pass(3000); // held on: no setting mode after it
        release(Key::Enter);
        release(Key::Down);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    /// §4.10: "When the light receiving state of CMOS is "unmeasurable", Zero set ON cannot be set."
    void zero_cannot_be_set_while_unmeasurable()
    {
        place(12'345);
        m_sensor->setLight(emulator::Light::Insufficient);
        pass(200);
        tapTogether(Key::Up, Key::Down);
        QVERIFY(!shown().icons.zero);
        QCOMPARE(shown().body, u"+1.2345"_s);
    }

    /// §4.11
    void up_and_enter_together_reset_the_measured_value()
    {
        QVERIFY(set(ItemId::HoldMode, 1));
        QVERIFY(set(ItemId::AverageTimes, 0));
        pass(100);
        place(30'000);
        place(10'000);
        QCOMPARE(shown().body, u"+3.0000"_s); // the peak
        hold({Key::Up, Key::Enter}, 100);
        pass(100);
        QCOMPARE(shown().body, u"+1.0000"_s);
    }

    // Key lock (§4.12)

    void up_and_down_held_for_two_seconds_lock_the_keys()
    {
        place(12'345);
        press(Key::Up);
        press(Key::Down);
        pass(1999);
        QCOMPARE(stored(ItemId::KeyLock), 0);
        pass(1);
        QCOMPARE(stored(ItemId::KeyLock), 1);
        QCOMPARE(shown().screen, ScreenKind::Message);
        QCOMPARE(shown().body, u"KEY LOCK ON"_s);
        release(Key::Up);
        release(Key::Down);
        pass(1900);
        QCOMPARE(shown().body, u"KEY LOCK ON"_s);
        pass(100);
        QCOMPARE(shown().body, u"+1.2345"_s); // zero was not set on the way
        QVERIFY(!shown().icons.zero);
    }

    /// "If you perform any key operation while the key lock setting enabled, "KEY LOCK ON" will be displayed
    /// on the display section and no key operation will be accepted."
    void every_key_shows_the_lock_and_does_nothing_else()
    {
        QVERIFY(set(ItemId::KeyLock, 1));
        for (const Key key : {Key::Up, Key::Enter, Key::Down}) {
            pass(2000);
            QCOMPARE(shown().screen, ScreenKind::Measurement);
            tap(key);
            QCOMPARE(shown().body, u"KEY LOCK ON"_s);
            pass(2000);
            holdLong(key);
            pass(2000);
            QCOMPARE(shown().screen, ScreenKind::Measurement);
        }
        tapTogether(Key::Up, Key::Down);
        pass(2000);
        QVERIFY(!shown().icons.zero);
        QVERIFY(m_sensor->isReady());
    }

    /// §4.12.2
    void up_and_down_held_again_unlock_them()
    {
        QVERIFY(set(ItemId::KeyLock, 1));
        press(Key::Up);
        press(Key::Down);
        QCOMPARE(shown().body, u"KEY LOCK ON"_s);
        pass(2000);
        QCOMPARE(stored(ItemId::KeyLock), 0);
        QCOMPARE(shown().body, u"KEY LOCK OFF"_s);
        release(Key::Up);
        release(Key::Down);
        pass(1900);
        QCOMPARE(shown().body, u"KEY LOCK OFF"_s);
        pass(100);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        tap(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::WindowValue);
    }

    /// §4.12.1, §4.12.2 notes
    void locking_over_communication_shows_nothing()
    {
        QVERIFY(set(ItemId::KeyLock, 1));
        pass(100);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(set(ItemId::KeyLock, 0));
        pass(100);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    // Eco mode (§4.8.2)

    void with_eco_mode_on_the_display_goes_off_after_180_s()
    {
        QVERIFY(set(ItemId::EcoMode, 1));
        tap(Key::Enter);
        tap(Key::Enter);
        pass(ecoMs - 100);
        QCOMPARE(shown().brightness, Brightness::Normal);
        pass(200);
        QCOMPARE(shown().brightness, Brightness::Off);
    }

    void with_eco_mode_off_it_dims_and_blinks_every_5_s()
    {
        QVERIFY(set(ItemId::EcoMode, 0));
        pass(100);
        tap(Key::Enter);
        tap(Key::Enter);
        pass(ecoMs + 100);
        QCOMPARE(shown().brightness, Brightness::Dim);
        int blinks = 0;
        Brightness before = Brightness::Dim;
        for (int i = 0; i < 200; ++i) { // 20 s
            pass(100);
            if (shown().brightness != before && shown().brightness == Brightness::Blink)
                ++blinks;
            before = shown().brightness;
            QVERIFY(before == Brightness::Dim || before == Brightness::Blink);
        }
        QCOMPARE(blinks, 4);
    }

    void the_first_key_only_brings_the_display_back()
    {
        pass(ecoMs + 100);
        QCOMPARE(shown().brightness, Brightness::Off);
        press(Key::Up);
        QCOMPARE(shown().brightness, Brightness::Normal);
        pass(3000); // held: no teaching
        release(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        tap(Key::Up);
        QCOMPARE(shown().screen, ScreenKind::WindowValue);
    }

    void communication_does_not_bring_it_back_but_a_change_of_the_eco_mode_does()
    {
        pass(ecoMs + 100);
        QVERIFY(set(ItemId::Offset, 5));
        QVERIFY(set(ItemId::EcoMode, 1)); // it is already
        pass(200);
        QCOMPARE(shown().brightness, Brightness::Off);
        QVERIFY(set(ItemId::EcoMode, 0));
        pass(100);
        QCOMPARE(shown().brightness, Brightness::Normal);
    }

    void a_setting_screen_goes_dark_too_and_stays_where_it_is()
    {
        QVERIFY(openMenu(31));
        pass(ecoMs + 100);
        QCOMPARE(shown().brightness, Brightness::Off);
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Entry);
        QCOMPARE(shown().edited, 0);
    }

    // Display inversion (§4.8.3), language (§4.8.4)

    void an_inverted_display_swaps_up_and_down()
    {
        QVERIFY(!shown().inverted);
        QVERIFY(openMenu(93));
        QVERIFY(choose(u"Inverted"_s));
        tap(Key::Enter);
        QVERIFY(shown().inverted);
        leaveMenus();
        tap(Key::Up);
        QCOMPARE(shown().title, u"LOW Set Value"_s);
        tap(Key::Up);
        tap(Key::Down);
        QCOMPARE(shown().title, u"HIGH Set Value"_s);
        tap(Key::Down);
        tapTogether(Key::Up, Key::Down);
        QVERIFY(shown().icons.zero);
        holdLong(Key::Down);
        QCOMPARE(shown().screen, ScreenKind::Prompt); // teaching, UP
    }

    void a_key_that_was_down_when_the_display_turned_is_let_go_as_the_same_key()
    {
        press(Key::Up);
        QVERIFY(set(ItemId::DisplayInversion, 1));
        release(Key::Up);
        QCOMPARE(shown().title, u"HIGH Set Value"_s);
    }

    void the_language_of_the_display_changes_at_once()
    {
        QVERIFY(openMenu(94));
        QVERIFY(choose(u"Japanese"_s));
        tap(Key::Enter);
        QCOMPARE(shown().language, emulator::PanelLanguage::Japanese);
        QCOMPARE(shown().body, u"言語"_s);
        tap(Key::Enter);
        QVERIFY(choose(u"简体中文"_s));
        tap(Key::Enter);
        QCOMPARE(shown().body, u"语言"_s);
        tap(Key::Enter);
        QVERIFY(choose(u"English"_s));
        tap(Key::Enter);
        QCOMPARE(shown().body, u"Language"_s);
    }

    // Power

    /// §3.6
    void after_power_on_the_start_up_screen_shows_for_two_seconds()
    {
        tap(Key::Up);
        m_sensor->powerCycle();
        QCOMPARE(shown().screen, ScreenKind::StartUp);
        QCOMPARE(shown().note, u"HL-G203B-S-MK"_s);
        QVERIFY(m_sensor->isReady());
        pass(1999);
        QCOMPARE(shown().screen, ScreenKind::StartUp);
        pass(1);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
    }

    /// §4.8.6 "Set value initialization", §3.6: "Initializing", language, NPN/PNP, measurement display.
    void enter_held_at_power_on_initializes_the_set_values()
    {
        QVERIFY(!m_sensor->writeByKeys({{ItemId::Offset, 5}}).refusal);
        QVERIFY(!m_sensor->writeByKeys({{ItemId::LanguageSetting, 2}}).refusal);
        QVERIFY(!m_sensor->writeByKeys({{ItemId::PortModbus, 1502}}).refusal);
        press(Key::Enter);
        m_sensor->powerCycle();
        pass(1999);
        QCOMPARE(shown().screen, ScreenKind::StartUp);
        QCOMPARE(stored(ItemId::Offset), 5);
        pass(1);
        QCOMPARE(shown().body, u"Initializing"_s);
        QCOMPARE(stored(ItemId::Offset), 0);
        QCOMPARE(stored(ItemId::PortModbus), 1502);
        QVERIFY(!m_sensor->isReady());
        release(Key::Enter);
        pass(1999);
        QCOMPARE(shown().body, u"Initializing"_s);
        pass(1);
        QCOMPARE(shown().title, u"Language"_s);
        QCOMPARE(shown().body, u"English"_s);
        holdLong(Key::Enter); // nothing to go back to
        QCOMPARE(shown().title, u"Language"_s);
        tap(Key::Down);
        tap(Key::Enter);
        QCOMPARE(stored(ItemId::LanguageSetting), 1);
        QCOMPARE(shown().title, u"NPN/PNP"_s);
        QCOMPARE(shown().body, u"NPN"_s);
        QVERIFY(!m_sensor->isReady());
        tap(Key::Up);
        QCOMPARE(shown().body, u"PNP"_s);
        tap(Key::Enter);
        QCOMPARE(m_sensor->savedMemory().inputPolarity(), emulator::InputPolarity::Pnp);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(m_sensor->isReady());
    }

    /// "while holding down the ENTER key for 2 seconds or more"
    void enter_let_go_too_soon_at_power_on_does_nothing()
    {
        QVERIFY(!m_sensor->writeByKeys({{ItemId::Offset, 5}}).refusal);
        press(Key::Enter);
        m_sensor->powerCycle();
        pass(1900);
        release(Key::Enter);
        pass(200);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QCOMPARE(stored(ItemId::Offset), 5);
    }

    void a_power_cycle_ends_the_setting_mode()
    {
        QVERIFY(openMenu(31));
        m_sensor->powerCycle();
        pass(2000);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(m_sensor->isReady());
    }

    void leaving_the_keys_ends_what_was_being_done()
    {
        QVERIFY(openMenu(31));
        m_panel->leave();
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(m_sensor->isReady());
        holdLong(Key::Up);
        QVERIFY(m_sensor->teaching().isExecuting());
        m_panel->leave();
        QVERIFY(!m_sensor->teaching().isExecuting());
        QVERIFY(m_sensor->isReady());
    }

    void what_is_seen_is_told_once_for_each_change()
    {
        QList<DisplayContent> told;
        connect(m_panel.get(), &FrontPanel::contentChanged, this,
                [&told](const DisplayContent& content) { told.append(content); });
        pass(1000);
        QCOMPARE(told.size(), 0); // it stands still
        place(12'345);
        pass(1000);
        QCOMPARE(told.size(), 1);
        QCOMPARE(told.last(), m_panel->content());
    }
};

QTEST_GUILESS_MAIN(TestPanelOperations)
#include "tst_panel_operations.moc"
