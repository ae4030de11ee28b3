#include "panel_fixture.h"

#include <algorithm>
#include <QSignalSpy>
#include <QTest>

using namespace lds;
using namespace lds::catalog;
using namespace lds::test;
using namespace Qt::StringLiterals;

/// The setting mode (§2.2) with all it sets (chapter 4, §5.1.1).
class TestSettingMode : public PanelFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    /// §2.2: "Hold down the ENTER key for 2 seconds on the measurement display."
    void enter_held_for_two_seconds_opens_the_first_level()
    {
        press(Key::Enter);
        pass(1999);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        pass(1);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QCOMPARE(shown().menuNumber, 1);
        QCOMPARE(shown().hierarchyBars, 1);
        QCOMPARE(shown().body, u"Bank"_s);
        release(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QVERIFY(!m_sensor->isReady());
    }

    /// §2.2 "Setting items corresponding to menu numbers": every entry with its number, bars and name.
    void every_menu_entry_is_reached_by_its_number()
    {
        for (const MenuEntry& entry : Catalog::hlG2().menu()) {
            QVERIFY2(goToMenu(entry.number), entry.name);
            QCOMPARE(shown().hierarchyBars, int(QString::number(entry.number).size()));
            QCOMPARE(shown().body, QString::fromUtf8(entry.name));
            if (!entry.items.empty()) {
                tap(Key::Enter);
                QVERIFY2(shown().screen != ScreenKind::Menu, entry.name);
                QCOMPARE(shown().menuNumber, entry.number);
                QCOMPARE(shown().title, QString::fromUtf8(entry.name));
            }
            leaveMenus();
        }
    }

    void a_level_goes_round_in_both_directions()
    {
        holdLong(Key::Enter);
        tap(Key::Up);
        QCOMPARE(shown().menuNumber, 9);
        tap(Key::Down);
        QCOMPARE(shown().menuNumber, 1);
    }

    /// Every chapter's note: "Hold down the ENTER key for 2 seconds on the setting screen, and the setting
    /// change is suspended and the screen returns to the previous display."
    void enter_held_for_two_seconds_goes_back_level_by_level()
    {
        QVERIFY(openMenu(421));
        const QString before = shown().body;
        tap(Key::Down);
        QVERIFY(shown().body != before);
        holdLong(Key::Enter);
        QCOMPARE(shown().menuNumber, 421);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        holdLong(Key::Enter);
        QCOMPARE(shown().menuNumber, 42);
        holdLong(Key::Enter);
        QCOMPARE(shown().menuNumber, 4);
        holdLong(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Measurement);
        QVERIFY(m_sensor->isReady());
        QCOMPARE(stored(ItemId::OutputDelayTimerSelection), 0); // suspended
    }

    void every_choice_of_every_item_can_be_stored()
    {
        for (const MenuEntry& entry : Catalog::hlG2().menu()) {
            if (entry.items.empty() || hlG2(entry.items.front()).kind != Kind::Choice)
                continue;
            const SettingItem& item = hlG2(entry.items.front());
            if (item.role == Role::Command || item.role == Role::Procedure ||
                item.id == ItemId::LanguageSetting || item.id == ItemId::TriggerMode)
                continue; // have tests of their own
            for (const Choice& choice : item.choices) {
                if (!(choice.models & maskOf(m_sensor->model())))
                    continue;
                QVERIFY(openMenu(entry.number));
                QVERIFY2(choose(QString::fromUtf8(choice.name).replace(u'µ', u'u')), choice.name);
                tap(Key::Enter);
                QCOMPARE(stored(item.id), choice.code);
                QCOMPARE(m_sensor->savedMemory().value(item.id), choice.code);
                QCOMPARE(shown().menuNumber, entry.number);
                leaveMenus();
            }
        }
    }

    /// §4.8.1: a type has not every display digit.
    void only_the_choices_of_the_type_are_offered()
    {
        setUp(SensorModel::HlG225);
        QVERIFY(openMenu(91));
        QStringList offered;
        for (int i = 0; i < 4; ++i) {
            offered += shown().body;
            tap(Key::Down);
        }
        QCOMPARE(offered, (QStringList{u"2 digits (0.01)"_s, u"1 digit (0.1)"_s, u"0 digits (1)"_s,
                                       u"2 digits (0.01)"_s}));
    }

    /// §4.6.2: "Trigger mode can be set to "One Shot" only when "None (Normal mode)" is selected"
    void a_refused_choice_shows_an_error_and_stays()
    {
        QVERIFY(set(ItemId::HoldMode, 1));
        QVERIFY(openMenu(53));
        QVERIFY(choose(u"One Shot"_s));
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Choice);
        QCOMPARE(shown().note, u"Error"_s);
        QCOMPARE(stored(ItemId::TriggerMode), 0);
        pass(2000);
        QCOMPARE(shown().note, QString());
        QCOMPARE(shown().screen, ScreenKind::Choice);
    }

    // Digits

    /// §4.3.6, §4.3.7, §4.5.2, §4.7.1, §5.2.1, §6.2: range and resolution decide on the digits.
    void the_digits_of_an_entry_come_from_the_limits_data()
    {
        QTest::addColumn<SensorModel>("model");
        QTest::addColumn<int>("menu");
        QTest::addColumn<QString>("text");
        QTest::newRow("span") << SensorModel::HlG203 << 26 << u"1.0000"_s;
        QTest::newRow("offset, 30 mm") << SensorModel::HlG203 << 27 << u"+0.0000"_s;
        QTest::newRow("offset, 250 mm") << SensorModel::HlG225 << 27 << u"+000.00"_s;
        QTest::newRow("high, 30 mm") << SensorModel::HlG203 << 31 << u"+5.0000"_s;
        QTest::newRow("high, 50 mm") << SensorModel::HlG205 << 31 << u"+10.000"_s;
        QTest::newRow("low, 120 mm") << SensorModel::HlG212 << 32 << u"-30.000"_s;
        QTest::newRow("low, 250 mm") << SensorModel::HlG225 << 32 << u"-150.00"_s;
        QTest::newRow("hysteresis, 85 mm") << SensorModel::HlG208 << 33 << u"00.040"_s;
        QTest::newRow("tolerance, 30 mm") << SensorModel::HlG203 << 35 << u"2.0000"_s;
        QTest::newRow("timer") << SensorModel::HlG203 << 422 << u"001"_s;
        QTest::newRow("alarm delay count") << SensorModel::HlG203 << 63 << u"00008"_s;
        QTest::newRow("IP address") << SensorModel::HlG203 << 71 << u"192.168.001.006"_s;
        QTest::newRow("subnet mask") << SensorModel::HlG203 << 72 << u"255.255.255.000"_s;
        QTest::newRow("tool port") << SensorModel::HlG203 << 74 << u"49152"_s;
        QTest::newRow("SLMP port") << SensorModel::HlG203 << 76 << u"45237"_s;
        QTest::newRow("network and node") << SensorModel::HlG203 << 77 << u"000/255"_s;
        QTest::newRow("device address") << SensorModel::HlG203 << 82 << u"001"_s;
    }
    void the_digits_of_an_entry_come_from_the_limits()
    {
        QFETCH(SensorModel, model);
        QFETCH(int, menu);
        QFETCH(QString, text);
        setUp(model);
        QVERIFY(openMenu(menu));
        QCOMPARE(shown().screen, ScreenKind::Entry);
        QCOMPARE(shown().body, text);
        QCOMPARE(shown().edited, 0);
    }

    void a_digit_goes_round_and_the_sign_changes()
    {
        QVERIFY(openMenu(27));
        tap(Key::Up);
        QCOMPARE(shown().body, u"-0.0000"_s);
        tap(Key::Down);
        QCOMPARE(shown().body, u"+0.0000"_s);
        tap(Key::Enter);
        tap(Key::Down);
        QCOMPARE(shown().body, u"+9.0000"_s);
        tap(Key::Up);
        QCOMPARE(shown().body, u"+0.0000"_s);
    }

    void the_last_digit_stores_the_value()
    {
        QVERIFY(openMenu(27));
        enter(u"-1.2345"_s);
        QCOMPARE(stored(ItemId::Offset), -12'345);
        QCOMPARE(m_sensor->savedMemory().value(ItemId::Offset), -12'345);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QCOMPARE(shown().menuNumber, 27);
    }

    void the_resolution_of_the_type_scales_what_is_entered()
    {
        setUp(SensorModel::HlG225);
        QVERIFY(openMenu(31));
        enter(u"+123.45"_s);
        QCOMPARE(stored(ItemId::HighSetValue), 1'234'500);
    }

    /// "Simultaneously pressing the UP and DOWN keys while moving between the digits returns to the first
    /// digit (sign)."
    void up_and_down_together_return_to_the_first_digit()
    {
        QVERIFY(openMenu(31));
        tap(Key::Enter, 3);
        QCOMPARE(shown().edited, 4);
        tapTogether(Key::Up, Key::Down);
        QCOMPARE(shown().edited, 0);
        QCOMPARE(shown().body, u"+5.0000"_s); // neither of the two has changed a digit
    }

    void a_long_enter_suspends_the_entry()
    {
        QVERIFY(openMenu(31));
        tap(Key::Enter);
        tap(Key::Up, 3);
        holdLong(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QCOMPARE(stored(ItemId::HighSetValue), 50'000);
    }

    /// §4.4.1: "If the value is not greater than the LOW set value, an error will occur."
    void a_refused_value_shows_an_error_and_stays_in_entry_data()
    {
        QTest::addColumn<int>("menu");
        QTest::addColumn<QString>("text");
        QTest::addColumn<ItemId>("item");
        QTest::newRow("not above LOW (§4.4.1)") << 31 << u"-6.0000"_s << ItemId::HighSetValue;
        QTest::newRow("not below HIGH (§4.4.2)") << 32 << u"+6.0000"_s << ItemId::LowSetValue;
        QTest::newRow("out of range (§4.3.7)") << 27 << u"+9.5001"_s << ItemId::Offset;
        QTest::newRow("below the range (§4.3.6)") << 26 << u"0.0999"_s << ItemId::Span;
        QTest::newRow("tolerance not above hysteresis (§4.4.5)") << 35 << u"0.0100"_s << ItemId::Tolerance;
        QTest::newRow("hysteresis too large (§4.4.3)") << 33 << u"5.0000"_s << ItemId::Hysteresis;
        QTest::newRow("timer (§4.5.2)") << 422 << u"101"_s << ItemId::OutputDelayTimerSetting;
        QTest::newRow("reserved port (§5.2.1)") << 75 << u"44818"_s << ItemId::PortModbus;
        QTest::newRow("both ports the same (§5.2.1)") << 74 << u"00502"_s << ItemId::PortTool;
        QTest::newRow("device address (§6.2)") << 82 << u"248"_s << ItemId::DeviceAddress;
    }
    void a_refused_value_shows_an_error_and_stays_in_entry()
    {
        QFETCH(int, menu);
        QFETCH(QString, text);
        QFETCH(ItemId, item);
        const Value before = stored(item);
        QVERIFY(openMenu(menu));
        enter(text);
        QCOMPARE(shown().screen, ScreenKind::Entry);
        QCOMPARE(shown().note, u"Error"_s);
        QCOMPARE(shown().body, text);
        QCOMPARE(shown().edited, 0);
        QCOMPARE(stored(item), before);
        pass(2000);
        QCOMPARE(shown().note, QString());
        QCOMPARE(shown().screen, ScreenKind::Entry);
    }

    // Ethernet (§5.1.1)

    void an_ip_address_is_entered_octet_by_octet_and_judged_as_one()
    {
        QVERIFY(openMenu(71));
        enter(u"192.168.001.020"_s);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QCOMPARE(stored(ItemId::IpAddress4thOctet), 20);
        tap(Key::Enter);
        enter(u"192.168.002.020"_s); // not the gateway's network
        QCOMPARE(shown().note, u"Error"_s);
        QCOMPARE(stored(ItemId::IpAddress3rdOctet), 1);
        enter(u"192.168.001.300"_s);
        QCOMPARE(shown().note, u"Error"_s);
    }

    /// §5.1.1 note: the way round a refused combination.
    void without_a_gateway_another_network_can_be_set()
    {
        QVERIFY(openMenu(73));
        enter(u"000.000.000.000"_s);
        leaveMenus();
        QVERIFY(openMenu(71));
        enter(u"010.000.000.005"_s);
        leaveMenus();
        QVERIFY(openMenu(73));
        enter(u"010.000.000.001"_s);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QCOMPARE(stored(ItemId::IpAddress1stOctet), 10);
        QCOMPARE(stored(ItemId::DefaultGateway1stOctet), 10);
    }

    /// §5.1.1: "You can check the MAC address on the screen, but not set it."
    void the_mac_address_is_shown_and_cannot_be_edited()
    {
        m_panel->setMacAddress(QByteArray::fromHex("0250c2a1b2c3"));
        QVERIFY(openMenu(78));
        QCOMPARE(shown().body, u"02:50:C2:A1:B2:C3"_s);
        QCOMPARE(shown().edited, -1);
        tap(Key::Up);
        tap(Key::Down);
        QCOMPARE(shown().body, u"02:50:C2:A1:B2:C3"_s);
        tap(Key::Enter);
        QCOMPARE(shown().menuNumber, 78);
        QCOMPARE(shown().screen, ScreenKind::Menu);
    }

    /// §2.2: menus 76 and 77 have no address in any protocol; the keys reach them.
    void what_only_the_keys_reach_is_stored()
    {
        QVERIFY(openMenu(76));
        enter(u"45238"_s);
        QCOMPARE(stored(ItemId::PortSlmp), 45'238);
        leaveMenus();
        QVERIFY(openMenu(77));
        enter(u"012/034"_s);
        QCOMPARE(stored(ItemId::NetworkNumber), 12);
        QCOMPARE(stored(ItemId::NodeNumber), 34);
    }

    // System (§4.8)

    /// §4.8.5
    void comm_reset_offers_cancel_first_and_resets()
    {
        QSignalSpy reset(m_sensor.get(), &emulator::VirtualSensor::communicationReset);
        QVERIFY(openMenu(95));
        QCOMPARE(shown().body, u"Cancel"_s);
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Menu);
        QCOMPARE(reset.size(), 0);
        tap(Key::Enter);
        tap(Key::Down);
        QCOMPARE(shown().body, u"Reset"_s);
        tap(Key::Enter);
        QCOMPARE(reset.size(), 1);
        QCOMPARE(shown().menuNumber, 95);
    }

    /// §4.8.6
    void initialize_offers_cancel_the_banks_and_the_areas()
    {
        QVERIFY(openMenu(96));
        QStringList offered;
        for (int i = 0; i < 7; ++i) {
            offered += shown().body;
            tap(Key::Down);
        }
        QCOMPARE(offered, (QStringList{u"Cancel"_s, u"Bank 1"_s, u"Bank 2"_s, u"Bank 3"_s, u"Bank 4"_s,
                                       u"All Banks"_s, u"All Areas"_s}));
        QCOMPARE(shown().body, u"Cancel"_s);
        tap(Key::Enter);
        QCOMPARE(shown().screen, ScreenKind::Menu);
    }

    /// §4.8.6: one bank goes back to the factory values; the keys mean nothing meanwhile.
    void initialize_puts_a_bank_back()
    {
        QVERIFY(set(ItemId::Offset, 5));
        QVERIFY(set(ItemId::EcoMode, 0));
        QVERIFY(openMenu(96));
        QVERIFY(choose(u"Bank 1"_s));
        tap(Key::Enter);
        QCOMPARE(stored(ItemId::Offset), 0);
        QCOMPARE(stored(ItemId::EcoMode), 0); // not the bank's
        QCOMPARE(shown().body, u"Initializing"_s);
        tap(Key::Enter);
        QCOMPARE(shown().body, u"Initializing"_s);
        pass(2000);
        QCOMPARE(shown().menuNumber, 96);
    }

    void all_areas_puts_everything_back()
    {
        QVERIFY(set(ItemId::EcoMode, 0));
        QVERIFY(openMenu(96));
        QVERIFY(choose(u"All Areas"_s));
        tap(Key::Enter);
        QCOMPARE(stored(ItemId::EcoMode), 1);
    }

    /// §4.2
    void the_bank_is_switched_from_the_first_level()
    {
        QVERIFY(openMenu(1));
        QVERIFY(choose(u"Bank 3"_s));
        tap(Key::Enter);
        leaveMenus();
        QCOMPARE(shown().icons.bank, u"B3"_s);
    }

    /// §5.2.2: "not ready" as long as the setting mode lasts.
    void commands_are_refused_in_the_setting_mode()
    {
        holdLong(Key::Enter);
        QCOMPARE(m_sensor->write({{ItemId::Offset, 5}}).refusal, emulator::Refusal::NotReady);
        leaveMenus();
        QVERIFY(set(ItemId::Offset, 5));
    }
};

QTEST_GUILESS_MAIN(TestSettingMode)
#include "tst_setting_mode.moc"
