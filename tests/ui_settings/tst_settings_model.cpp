#include "page_fixture.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

using namespace lds;
using namespace lds::ui;
using catalog::Role;

class SettingsModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyMenuNumberIsARowWithItsLevel();
    void childrenStandUnderTheirHeading();
    void whatCanBeSetIsARowAndAStatusIsNot();
    void valuesAreExactAndBesideTheirUnit();
    void decimalsFollowTheType();
    void anAddressIsOneRow();
    void anItemWithoutAddressSaysSo();
    void beforeReadingEveryRowSaysNotReadYet();
    void aPendingEditShowsBothValues();
    void aMovedValueUnderAnEditIsAConflict();
    void brokenRulesMarkTheirRows();
    void cutOffValuesAreStaleAndSaySo();
    void aChangedValueUpdatesItsRowOnly();
    void switchesCommandsAndProceduresCarryAButtonAndAreNotEditable();
    void ofAProcedureOnlyTheWayBackIsOffered();
    void viewOnlyEditsNothing();
    void wrongInputIsKeptForEachSensor();
    void cellsSpeakTheCatalogsNames();
    void noSessionIsAnEmptyModel();
    void aDeletedSessionEmptiesTheModel();
};

namespace {

int level(const SettingsModel& model, int menu) { return model.tree()->findMenu(menu)->level; }

} // namespace

void SettingsModelTest::everyMenuNumberIsARowWithItsLevel()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setSession(fixture.session.get());

    // §2.2, as printed.
    const QList<int> numbers{1,  2,  3,  4,  5,  6,  7,  8,  9,  21, 22, 23, 24,  25, 26, 27,
                             31, 32, 33, 34, 35, 42, 52, 53, 62, 63, 71, 72, 73,  74, 75, 76,
                             77, 78, 81, 82, 83, 84, 91, 92, 93, 94, 95, 96, 421, 422};
    QCOMPARE(numbers.size(), 46);
    int rowsWithNumber = 0;
    for (const SettingRow* row : model.tree()->all())
        rowsWithNumber += row->menu != 0;
    QCOMPARE(rowsWithNumber, 46);
    for (const int number : numbers) {
        const SettingRow* row = model.tree()->findMenu(number);
        QVERIFY2(row, qPrintable(QString::number(number)));
        QCOMPARE(row->level, int(QString::number(number).size()));
        QCOMPARE(model.indexOf(row).data().toString(), QString::number(number));
        QVERIFY(!model.indexOf(row, SettingsModel::Item).data().toString().isEmpty());
    }
    QCOMPARE(level(model, 421), 3);
}

void SettingsModelTest::childrenStandUnderTheirHeading()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    const QModelIndex timer = model.indexOf(model.tree()->findMenu(42));
    QCOMPARE(model.rowCount(timer), 2);
    QCOMPARE(model.indexOf(ItemId::OutputDelayTimerSetting).parent(), timer);
    QCOMPARE(timer.parent(), model.indexOf(model.tree()->findMenu(4)));
    QVERIFY(!timer.parent().parent().isValid());
    QVERIFY(!(model.flags(timer.siblingAtColumn(SettingsModel::NewValue)) & Qt::ItemIsEditable));
}

void SettingsModelTest::whatCanBeSetIsARowAndAStatusIsNot()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    for (const auto& item : catalog::Catalog::hlG2().items()) {
        const bool isRow = model.indexOf(item.id).isValid();
        if (item.role == Role::Status && item.menu == 0)
            QVERIFY2(!isRow, item.key);
        else
            QVERIFY2(isRow, item.key);
    }
    const QModelIndex last = model.index(model.rowCount() - 1, SettingsModel::Item);
    QCOMPARE(last.data().toString(), QStringLiteral("Without a menu number"));
    QCOMPARE(model.indexOf(ItemId::KeyLock).parent(), last.siblingAtColumn(0));
    QCOMPARE(model.indexOf(ItemId::ZeroSetting).parent(), last.siblingAtColumn(0));
}

void SettingsModelTest::valuesAreExactAndBesideTheirUnit()
{
    SensorFixture fixture;
    fixture.sensor().set(ItemId::HighSetValue, 17501);
    fixture.sensor().set(ItemId::LowSetValue, -7500);
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    QCOMPARE(cell(model, ItemId::HighSetValue, SettingsModel::InSensor), QStringLiteral("+1.7501"));
    QCOMPARE(cell(model, ItemId::LowSetValue, SettingsModel::InSensor), QStringLiteral("\u22120.7500"));
    QCOMPARE(cell(model, ItemId::LowSetValue, SettingsModel::NewValue), QStringLiteral("\u22120.7500"));
    QCOMPARE(cell(model, ItemId::LowSetValue, SettingsModel::Unit), QStringLiteral("mm"));
    QCOMPARE(cell(model, ItemId::LowSetValue, SettingsModel::Range),
             QStringLiteral("\u22129.5000 … +9.5000"));
    QCOMPARE(cell(model, ItemId::LowSetValue, SettingsModel::Default), QStringLiteral("\u22125.0000"));
    QCOMPARE(cell(model, ItemId::AverageTimes, SettingsModel::Default), QStringLiteral("512 times"));
    const auto alignment =
        model.indexOf(ItemId::Span, SettingsModel::InSensor).data(Qt::TextAlignmentRole).toInt();
    QVERIFY(alignment & Qt::AlignRight);
}

void SettingsModelTest::decimalsFollowTheType()
{
    SensorFixture fixture(catalog::SensorModel::HlG225);
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    QCOMPARE(cell(model, ItemId::HighSetValue, SettingsModel::Default), QStringLiteral("+150.00"));
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    fixture.session->setModel(catalog::SensorModel::HlG205);
    QVERIFY(!changed.isEmpty());
    QCOMPARE(cell(model, ItemId::HighSetValue, SettingsModel::Default), QStringLiteral("+10.000"));
}

void SettingsModelTest::anAddressIsOneRow()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    QCOMPARE(cell(model, ItemId::IpAddress3rdOctet, SettingsModel::InSensor), QStringLiteral("192.168.1.6"));
    QCOMPARE(model.indexOf(ItemId::IpAddress1stOctet), model.indexOf(ItemId::IpAddress4thOctet));
    fixture.session->edit({{ItemId::IpAddress4thOctet, 77}});
    QCOMPARE(cell(model, ItemId::IpAddress1stOctet, SettingsModel::NewValue), QStringLiteral("192.168.1.77"));
    QCOMPARE(cell(model, ItemId::IpAddress1stOctet, SettingsModel::InSensor), QStringLiteral("192.168.1.6"));
    QVERIFY(statesOf(model, ItemId::IpAddress1stOctet).testFlag(SettingsModel::Edited));
}

void SettingsModelTest::anItemWithoutAddressSaysSo()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    for (const auto item : {ItemId::PortSlmp, ItemId::NodeNumber, ItemId::MacAddress}) {
        QCOMPARE(cell(model, item, SettingsModel::InSensor), QStringLiteral("not reachable over Modbus"));
        QVERIFY(!cell(model, item, SettingsModel::InSensor, Qt::ToolTipRole).isEmpty());
        QVERIFY(!(model.flags(model.indexOf(item, SettingsModel::NewValue)) & Qt::ItemIsEditable));
    }
}

void SettingsModelTest::beforeReadingEveryRowSaysNotReadYet()
{
    SensorFixture fixture;
    SettingsModel model;
    model.setSession(fixture.session.get());
    QCOMPARE(cell(model, ItemId::HighSetValue, SettingsModel::InSensor), QStringLiteral("not read yet"));
    QCOMPARE(cell(model, ItemId::HighSetValue, SettingsModel::NewValue), QString());
    QVERIFY(
        !(model.flags(model.indexOf(ItemId::HighSetValue, SettingsModel::NewValue)) & Qt::ItemIsEditable));
    fixture.open();
    QCOMPARE(cell(model, ItemId::HighSetValue, SettingsModel::InSensor), QStringLiteral("+5.0000"));
    QVERIFY(model.flags(model.indexOf(ItemId::HighSetValue, SettingsModel::NewValue)) & Qt::ItemIsEditable);
}

void SettingsModelTest::aPendingEditShowsBothValues()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QVERIFY(fixture.session->editText(ItemId::LowSetValue, QStringLiteral("0.75")));
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed.at(0).at(0).toModelIndex(), model.indexOf(ItemId::LowSetValue));
    QCOMPARE(cell(model, ItemId::LowSetValue, SettingsModel::InSensor), QStringLiteral("\u22125.0000"));
    QCOMPARE(cell(model, ItemId::LowSetValue, SettingsModel::NewValue), QStringLiteral("+0.7500"));
    QVERIFY(statesOf(model, ItemId::LowSetValue).testFlag(SettingsModel::Edited));
    QVERIFY(!statesOf(model, ItemId::HighSetValue).testFlag(SettingsModel::Edited));
    fixture.session->undo();
    QVERIFY(!statesOf(model, ItemId::LowSetValue).testFlag(SettingsModel::Edited));
}

void SettingsModelTest::aMovedValueUnderAnEditIsAConflict()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    fixture.session->edit({{ItemId::AverageTimes, 3}});
    QVERIFY(!statesOf(model, ItemId::AverageTimes).testFlag(SettingsModel::Conflict));
    fixture.changeElsewhere(ItemId::AverageTimes, 1);
    QVERIFY(statesOf(model, ItemId::AverageTimes).testFlag(SettingsModel::Conflict));
    const QString tip = cell(model, ItemId::AverageTimes, SettingsModel::NewValue, Qt::ToolTipRole);
    QVERIFY2(tip.contains(QStringLiteral("4 times")), qPrintable(tip));
    fixture.session->keepMine(ItemId::AverageTimes);
    QVERIFY(!statesOf(model, ItemId::AverageTimes).testFlag(SettingsModel::Conflict));
    QVERIFY(statesOf(model, ItemId::AverageTimes).testFlag(SettingsModel::Edited));
}

void SettingsModelTest::brokenRulesMarkTheirRows()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    fixture.session->edit({{ItemId::LowSetValue, 60000}}); // above HIGH, +5.0000 mm (§4.4.1)
    QVERIFY(statesOf(model, ItemId::LowSetValue).testFlag(SettingsModel::Problem));
    QVERIFY(statesOf(model, ItemId::HighSetValue).testFlag(SettingsModel::Problem));
    QVERIFY(!statesOf(model, ItemId::Offset).testFlag(SettingsModel::Problem));
    QVERIFY(!model.problems(*model.tree()->find(ItemId::LowSetValue)).isEmpty());
    fixture.session->edit({{ItemId::HighSetValue, 70000}});
    QVERIFY(!statesOf(model, ItemId::LowSetValue).testFlag(SettingsModel::Problem));
    QVERIFY(!statesOf(model, ItemId::HighSetValue).testFlag(SettingsModel::Problem));
}

void SettingsModelTest::cutOffValuesAreStaleAndSaySo()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    const auto header = [&model] {
        return model.headerData(SettingsModel::InSensor, Qt::Horizontal, Qt::DisplayRole).toString();
    };
    QCOMPARE(header(), QStringLiteral("In the sensor"));
    QVERIFY(!statesOf(model, ItemId::Span).testFlag(SettingsModel::Stale));
    QSignalSpy headers(&model, &QAbstractItemModel::headerDataChanged);
    fixture.cut();
    QCOMPARE(header(), QStringLiteral("Last known"));
    QVERIFY(!headers.isEmpty());
    QVERIFY(statesOf(model, ItemId::Span).testFlag(SettingsModel::Stale));
    QCOMPARE(cell(model, ItemId::Span, SettingsModel::InSensor), QStringLiteral("1.0000"));
    QVERIFY(cell(model, ItemId::Span, SettingsModel::InSensor, Qt::AccessibleTextRole)
                .contains(QStringLiteral("not connected")));
}

void SettingsModelTest::aChangedValueUpdatesItsRowOnly()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    fixture.changeElsewhere(ItemId::Span, 12345);
    QCOMPARE(reset.size(), 0);
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed.at(0).at(0).toModelIndex(), model.indexOf(ItemId::Span));
    QCOMPARE(cell(model, ItemId::Span, SettingsModel::InSensor), QStringLiteral("1.2345"));
}

void SettingsModelTest::switchesCommandsAndProceduresCarryAButtonAndAreNotEditable()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    for (const auto item : {ItemId::BankSwitching, ItemId::LaserStop, ItemId::ResettingCommunicationSettings,
                            ItemId::SettingsInitialization, ItemId::BrightnessTuning, ItemId::KeyLock}) {
        QVERIFY(!cell(model, item, SettingsModel::NewValue, SettingsModel::ButtonRole).isEmpty());
        QVERIFY(!(model.flags(model.indexOf(item, SettingsModel::NewValue)) & Qt::ItemIsEditable));
    }
    QCOMPARE(cell(model, ItemId::LaserStop, SettingsModel::Range), QStringLiteral("acts at once"));
    QCOMPARE(cell(model, ItemId::HoldMode, SettingsModel::NewValue, SettingsModel::ButtonRole), QString());
    QCOMPARE(cell(model, ItemId::Teaching1stPoint, SettingsModel::InSensor),
             QStringLiteral("step of a procedure"));
    QCOMPARE(cell(model, ItemId::Teaching1stPoint, SettingsModel::NewValue, SettingsModel::ButtonRole),
             QString());
}

void SettingsModelTest::ofAProcedureOnlyTheWayBackIsOffered()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    const auto orders = model.tree()->find(ItemId::BrightnessTuning)->orders(fixture.session->model());
    QCOMPARE(orders.size(), 2);
    for (const auto& order : orders)
        QCOMPARE(order.offered, order.value == 0);
    const auto banks = model.tree()->find(ItemId::BankSwitching)->orders(fixture.session->model());
    QCOMPARE(banks.size(), 4);
    for (const auto& order : banks)
        QVERIFY(order.offered);
}

void SettingsModelTest::viewOnlyEditsNothing()
{
    SensorFixture fixture(catalog::SensorModel::HlG203, true);
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    for (const SettingRow* row : model.tree()->all())
        QVERIFY(!(model.flags(model.indexOf(row, SettingsModel::NewValue)) & Qt::ItemIsEditable));
    QVERIFY(statesOf(model, ItemId::LaserStop).testFlag(SettingsModel::Unusable));
    QVERIFY(!cell(model, ItemId::Span, SettingsModel::NewValue, Qt::ToolTipRole).isEmpty());
}

void SettingsModelTest::wrongInputIsKeptForEachSensor()
{
    SensorFixture one;
    SensorFixture other;
    one.open();
    other.open();
    SettingsModel model;
    model.setSession(one.session.get());
    const auto rowOf = [&model] { return model.tree()->find(ItemId::Span); };
    model.keepWrongInput(*rowOf(), {QStringLiteral("1..2"), QStringLiteral("why")});
    QVERIFY(statesOf(model, ItemId::Span).testFlag(SettingsModel::WrongText));
    QCOMPARE(cell(model, ItemId::Span, SettingsModel::NewValue), QStringLiteral("1..2"));
    model.setSession(other.session.get());
    QVERIFY(!model.hasWrongInput());
    QCOMPARE(cell(model, ItemId::Span, SettingsModel::NewValue), QStringLiteral("1.0000"));
    model.setSession(one.session.get());
    QVERIFY(model.hasWrongInput());
    QCOMPARE(model.wrongInput(*rowOf()).message, QStringLiteral("why"));
    model.keepWrongInput(*rowOf(), {});
    QVERIFY(!model.hasWrongInput());
}

void SettingsModelTest::cellsSpeakTheCatalogsNames()
{
    SensorFixture fixture;
    fixture.open();
    SettingsModel model;
    model.setSession(fixture.session.get());
    fixture.session->edit({{ItemId::HighSetValue, 17500}});
    const QString spoken = cell(model, ItemId::HighSetValue, SettingsModel::NewValue, Qt::AccessibleTextRole);
    QCOMPARE(spoken, QStringLiteral("HIGH Set Value, New value: +1.7500, changed"));
    QCOMPARE(cell(model, ItemId::HighSetValue, SettingsModel::Item, Qt::AccessibleDescriptionRole),
             QString::fromUtf8(catalog::hlG2(ItemId::HighSetValue).help));
    QCOMPARE(cell(model, ItemId::OutputDelayTimerSetting, SettingsModel::Menu, Qt::AccessibleTextRole),
             QStringLiteral("Menu 422, level 3"));
}

void SettingsModelTest::noSessionIsAnEmptyModel()
{
    SettingsModel model;
    QCOMPARE(model.rowCount(), 0);
    SensorFixture fixture;
    model.setSession(fixture.session.get());
    QVERIFY(model.rowCount() > 0);
    model.setSession(nullptr);
    QCOMPARE(model.rowCount(), 0);
}

void SettingsModelTest::aDeletedSessionEmptiesTheModel()
{
    SettingsModel model;
    SensorFixture fixture;
    fixture.open();
    model.setSession(fixture.session.get());
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    fixture.session.reset();
    QCOMPARE(reset.size(), 1);
    QCOMPARE(model.rowCount(), 0);
    QVERIFY(!model.session());
}

QTEST_GUILESS_MAIN(SettingsModelTest)
#include "tst_settings_model.moc"
