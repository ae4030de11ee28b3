#include "page_fixture.h"
#include "settings_page.h"
#include "settings_view.h"

#include <QAccessible>
#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

using namespace lds;
using namespace lds::ui;

/// The settings page in a window, used with mouse and keys, on a sensor in memory.
class SettingsPageFlow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void editsTheJudgmentWindowByKeyboardOnly();
    void doubleClickAnywhereInARowEditsItsNewValue();
    void detailsSayRulesWithTheNumbersOfTheMoment();
    void detailsExplainAnUnreachableItem();
    void aRowThatCannotBeEditedSaysWhy();
    void rulesFollowNumbersOfOtherGroups();
    void keepMineAndTakeTheSensorsResolveAConflict();
    void aSwitchAsksByMenuAndIsNeverAPendingEdit();
    void aCommandNeedsAChoiceBeforeItIsRequested();
    void tuningOffersOnlyOff();
    void bankButtonsAskAndShowWhatTheSensorSays();
    void withoutConnectionNothingActsAndValuesAreMarked();
    void theFilterFindsSaysWhenNothingAndLetsGo();
    void changedOnlyShowsWhatWillBeApplied();
    void wrongTextHiddenByAFilterStopsFinishing();
    void wrongTextWaitsWhileAnotherSensorIsShown();
    void theContextMenuSetsTheDefaultAsAnEdit();
    void theRowIsCopiedForASpreadsheet();
    void showItemComesOutFromUnderAFilter();
    void aNarrowPageKeepsTheValuesAndDropsRangeAndDefault();
    void everythingThatTakesTheFocusHasAName();
    void tabGoesThroughThePageInReadingOrder();
    void withoutSensorThePageSaysWhatToDo();

private:
    template <typename Widget>
    Widget* find(const char* name) const
    {
        return m_page->findChild<Widget*>(QLatin1StringView(name));
    }
    QModelIndex indexOf(ItemId item, int column = SettingsModel::Menu) const
    {
        return find(m_view->model(), {}, item, column);
    }
    static QModelIndex find(const QAbstractItemModel* model, const QModelIndex& parent, ItemId item,
                            int column)
    {
        for (int row = 0; row < model->rowCount(parent); ++row) {
            const QModelIndex index = model->index(row, 0, parent);
            if (index.data(SettingsModel::RowRole).value<const SettingRow*>()->ids().contains(item))
                return index.siblingAtColumn(column);
            if (const QModelIndex below = find(model, index, item, column); below.isValid())
                return below;
        }
        return {};
    }
    QString shown(ItemId item, int column) const { return indexOf(item, column).data().toString(); }
    QString details() const
    {
        QStringList parts;
        for (const QLabel* label :
             m_page->findChild<QWidget*>(QStringLiteral("details"))->findChildren<QLabel*>()) {
            if (label->isVisible())
                parts += label->text();
        }
        return parts.join(u'\n');
    }
    void click(ItemId item, int column) const
    {
        m_view->scrollTo(indexOf(item));
        QTest::mouseClick(m_view->viewport(), Qt::LeftButton, {},
                          m_view->visualRect(indexOf(item, column)).center());
    }
    /// On the row's button, which stands at the right of the cell.
    QMenu* openOrders(ItemId item) const
    {
        m_view->scrollTo(indexOf(item));
        const QRect cell = m_view->visualRect(indexOf(item, SettingsModel::NewValue));
        QTest::mouseClick(m_view->viewport(), Qt::LeftButton, {},
                          QPoint(cell.right() - 20, cell.center().y()));
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }
    static void type(const QString& text)
    {
        for (const QChar c : text)
            QTest::keyClick(QApplication::focusWidget(), c.toLatin1());
    }
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    static void letGo() { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }

    std::unique_ptr<SensorFixture> m_fixture;
    std::unique_ptr<QWidget> m_window;
    SettingsPage* m_page = nullptr;
    SettingsView* m_view = nullptr;
};

void SettingsPageFlow::initTestCase() { Theme::instance().apply(*qApp, ThemeMode::Light); }

void SettingsPageFlow::init()
{
    m_fixture = std::make_unique<SensorFixture>();
    m_fixture->open();
    m_window = std::make_unique<QWidget>();
    auto* layout = new QVBoxLayout(m_window.get());
    m_page = new SettingsPage(m_window.get());
    layout->addWidget(m_page);
    m_window->resize(1180, 700);
    m_page->setSession(m_fixture->session.get());
    m_view = m_page->findChild<SettingsView*>();
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_view->setFocus();
}

void SettingsPageFlow::cleanup()
{
    m_window.reset();
    m_fixture.reset();
}

void SettingsPageFlow::editsTheJudgmentWindowByKeyboardOnly()
{
    m_page->focusFilter();
    type(QStringLiteral("31"));
    press(Qt::Key_Down);
    QVERIFY(m_view->hasFocus());
    find<QLineEdit>("filter")->clear();
    m_page->showItem(ItemId::HighSetValue);
    type(QStringLiteral("1.75"));
    press(Qt::Key_Return);
    type(QStringLiteral("0.75"));
    press(Qt::Key_Return);
    letGo();
    QCOMPARE(m_fixture->wanted(ItemId::HighSetValue), std::optional<Value>(17500));
    QCOMPARE(m_fixture->wanted(ItemId::LowSetValue), std::optional<Value>(7500));
    QCOMPARE(shown(ItemId::LowSetValue, SettingsModel::InSensor), QStringLiteral("\u22125.0000"));
    QCOMPARE(shown(ItemId::LowSetValue, SettingsModel::NewValue), QStringLiteral("+0.7500"));
    QCOMPARE(m_fixture->sensor().writes(), 0); // nothing is written before Apply
    m_page->showItem(ItemId::LowSetValue);
    press(Qt::Key_Delete);
    QVERIFY(!m_fixture->wanted(ItemId::LowSetValue));
    QVERIFY(m_fixture->wanted(ItemId::HighSetValue));
}

void SettingsPageFlow::doubleClickAnywhereInARowEditsItsNewValue()
{
    m_view->scrollTo(indexOf(ItemId::Span));
    const QPoint name = m_view->visualRect(indexOf(ItemId::Span, SettingsModel::Item)).center();
    QTest::mouseClick(m_view->viewport(), Qt::LeftButton, {}, name);
    QTest::mouseDClick(m_view->viewport(), Qt::LeftButton, {}, name);
    type(QStringLiteral("2"));
    press(Qt::Key_Return);
    QCOMPARE(m_fixture->wanted(ItemId::Span), std::optional<Value>(20000));
}

void SettingsPageFlow::detailsSayRulesWithTheNumbersOfTheMoment()
{
    m_page->showItem(ItemId::LowSetValue);
    QVERIFY2(details().contains(QStringLiteral("Menu 32 · Judgment")), qPrintable(details()));
    QVERIFY(details().contains(QStringLiteral("Less than the HIGH set value (+5.0000\u00a0mm).")));
    QVERIFY(details().contains(QStringLiteral("Modbus 400103, 2 registers")));
    QVERIFY(details().contains(QStringLiteral("Manual §4.4.2")));
    QVERIFY(details().contains(QStringLiteral("Kept per bank.")));
    m_fixture->session->edit({{ItemId::HighSetValue, 17500}, {ItemId::LowSetValue, 7500}});
    QVERIFY2(details().contains(QStringLiteral("Less than the HIGH set value (+1.7500\u00a0mm).")),
             qPrintable(details()));
    QVERIFY(details().contains(QStringLiteral("\u22125.0000 → <b>+0.7500\u00a0mm</b>")));
}

void SettingsPageFlow::detailsExplainAnUnreachableItem()
{
    m_page->showItem(ItemId::PortSlmp);
    QCOMPARE(shown(ItemId::PortSlmp, SettingsModel::InSensor), QStringLiteral("not reachable over Modbus"));
    QVERIFY2(details().contains(QStringLiteral("No protocol has an address for it.")), qPrintable(details()));
    press(Qt::Key_F2);
    QVERIFY(m_view->hasFocus()); // no editor
}

void SettingsPageFlow::aRowThatCannotBeEditedSaysWhy()
{
    m_page->showItem(ItemId::PortSlmp);
    type(QStringLiteral("4"));
    QVERIFY(QToolTip::isVisible());
    QVERIFY2(QToolTip::text().startsWith(QStringLiteral("No protocol has an address for it.")),
             qPrintable(QToolTip::text()));
    QCOMPARE(m_view->currentIndex().siblingAtColumn(0), indexOf(ItemId::PortSlmp)); // no search for "4"
    QToolTip::hideText();
}

void SettingsPageFlow::rulesFollowNumbersOfOtherGroups()
{
    m_page->showItem(ItemId::TriggerMode); // 53; hold mode is 24
    QVERIFY2(details().contains(QStringLiteral("Hold mode is “None (Normal mode)”.")), qPrintable(details()));
    m_fixture->session->edit({{ItemId::HoldMode, 1}});
    QTRY_VERIFY(details().contains(QStringLiteral("Hold mode is “Peak Hold”.")));
}

void SettingsPageFlow::keepMineAndTakeTheSensorsResolveAConflict()
{
    auto* session = m_fixture->session.get();
    m_page->showItem(ItemId::AverageTimes);
    session->edit({{ItemId::AverageTimes, 3}});
    QVERIFY(!find<QPushButton>("keepMine")->isVisible());
    m_fixture->changeElsewhere(ItemId::AverageTimes, 1);
    QVERIFY2(details().contains(QStringLiteral("from 512 times to 4 times")), qPrintable(details()));
    QTest::mouseClick(find<QPushButton>("keepMine"), Qt::LeftButton);
    QVERIFY(!find<QPushButton>("keepMine")->isVisible());
    QCOMPARE(m_fixture->wanted(ItemId::AverageTimes), std::optional<Value>(3));
    m_fixture->changeElsewhere(ItemId::AverageTimes, 2);
    QTest::mouseClick(find<QPushButton>("takeSensors"), Qt::LeftButton);
    QVERIFY(!m_fixture->wanted(ItemId::AverageTimes));
    QCOMPARE(shown(ItemId::AverageTimes, SettingsModel::NewValue), QStringLiteral("16 times"));
}

void SettingsPageFlow::aSwitchAsksByMenuAndIsNeverAPendingEdit()
{
    QSignalSpy requested(m_page, &SettingsPage::commandRequested);
    QMenu* menu = openOrders(ItemId::LaserStop);
    QVERIFY(menu);
    QCOMPARE(menu->actions().size(), 2);
    QVERIFY(menu->actions().at(0)->isChecked()); // OFF (laser emitted) is what the sensor holds
    QCOMPARE(requested.size(), 0);
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Return);
    QCOMPARE(requested.size(), 1);
    QCOMPARE(requested.at(0).at(0).value<ItemId>(), ItemId::LaserStop);
    QCOMPARE(requested.at(0).at(1).toInt(), 1);
    QVERIFY(m_fixture->session->pending().isEmpty());
}

void SettingsPageFlow::aCommandNeedsAChoiceBeforeItIsRequested()
{
    QSignalSpy requested(m_page, &SettingsPage::commandRequested);
    m_page->showItem(ItemId::ResettingCommunicationSettings);
    press(Qt::Key_Return);
    QPointer<QMenu> menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu);
    QCOMPARE(menu->actions().size(), 1);
    QTest::keyClick(menu, Qt::Key_Escape);
    QCOMPARE(requested.size(), 0);
    press(Qt::Key_Return);
    menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Return);
    QCOMPARE(requested.size(), 1);
    QCOMPARE(requested.at(0).at(0).value<ItemId>(), ItemId::ResettingCommunicationSettings);
    QCOMPARE(requested.at(0).at(1).toInt(), 0);
}

void SettingsPageFlow::tuningOffersOnlyOff()
{
    QMenu* menu = openOrders(ItemId::BrightnessTuning);
    QVERIFY(menu);
    QCOMPARE(menu->actions().size(), 2);
    QVERIFY(menu->actions().at(0)->isEnabled());
    QVERIFY(!menu->actions().at(1)->isEnabled());
    QVERIFY(menu->actions().at(1)->text().contains(QStringLiteral("starts a procedure")));
    menu->close();
}

void SettingsPageFlow::bankButtonsAskAndShowWhatTheSensorSays()
{
    QSignalSpy requested(m_page, &SettingsPage::commandRequested);
    auto* one = find<QPushButton>("bank1");
    auto* two = find<QPushButton>("bank2");
    QVERIFY(one->isChecked());
    QCOMPARE(one->accessibleName(), QStringLiteral("Bank 1, in use"));
    QTest::mouseClick(two, Qt::LeftButton);
    QCOMPARE(requested.size(), 1);
    QCOMPARE(requested.at(0).at(1).toInt(), 2);
    QVERIFY(one->isChecked()); // it has not switched yet
    QVERIFY(!two->isChecked());
    m_fixture->sensor().switchBank(2);
    m_fixture->session->readAll();
    support::settle();
    QVERIFY(two->isChecked());
    QVERIFY(!one->isChecked());
    QTest::mouseClick(two, Qt::LeftButton); // the one in use: nothing to do
    QCOMPARE(requested.size(), 1);
    QVERIFY(two->isChecked());
}

void SettingsPageFlow::withoutConnectionNothingActsAndValuesAreMarked()
{
    auto* note = find<QLabel>("staleNote");
    QVERIFY(!note->isVisible());
    m_fixture->cut();
    QVERIFY(note->isVisible());
    QVERIFY(!find<QPushButton>("bank2")->isEnabled());
    QMenu* menu = openOrders(ItemId::LaserStop);
    QVERIFY(menu);
    for (const QAction* action : menu->actions())
        QVERIFY(action->isSeparator() || !action->isEnabled());
    menu->close();
    m_fixture->sensor().allowOpenings();
    m_fixture->session->retryNow();
    support::settle();
    QVERIFY(!note->isVisible());
    QVERIFY(find<QPushButton>("bank2")->isEnabled());
}

void SettingsPageFlow::theFilterFindsSaysWhenNothingAndLetsGo()
{
    m_page->focusFilter();
    type(QStringLiteral("hysteresis"));
    QVERIFY(indexOf(ItemId::Hysteresis).isValid());
    QVERIFY(!indexOf(ItemId::EcoMode).isValid());
    QVERIFY(m_view->isExpanded(indexOf(ItemId::Hysteresis).parent()));
    const QImage found = m_view->viewport()->grab().toImage();
    type(QStringLiteral("zzz"));
    QCOMPARE(m_view->model()->rowCount(), 0);
    QCOMPARE(m_view->emptyText(),
             QStringLiteral("No item matches “hysteresiszzz”. Clear the filter to see all."));
    QVERIFY(m_view->viewport()->grab().toImage() != found);
    find<QLineEdit>("filter")->clear();
    QVERIFY(indexOf(ItemId::EcoMode).isValid());
    QVERIFY(m_view->isExpanded(indexOf(ItemId::OutputDelayTimerSetting).parent()));
}

void SettingsPageFlow::changedOnlyShowsWhatWillBeApplied()
{
    auto* box = find<QCheckBox>("changedOnly");
    box->setFocus();
    press(Qt::Key_Space);
    QCOMPARE(m_view->model()->rowCount(), 0);
    QCOMPARE(m_view->emptyText(),
             QStringLiteral("Nothing is changed. Every new value is the one in the sensor."));
    m_fixture->session->edit({{ItemId::OutputDelayTimerSetting, 20}});
    const QModelIndex row = indexOf(ItemId::OutputDelayTimerSetting);
    QVERIFY(row.isValid());
    QVERIFY(m_view->isExpanded(row.parent()));
    QVERIFY(m_view->isExpanded(row.parent().parent()));
    QVERIFY(!indexOf(ItemId::OutputDelayTimerSelection).isValid());
}

void SettingsPageFlow::wrongTextHiddenByAFilterStopsFinishing()
{
    m_page->showItem(ItemId::Span);
    type(QStringLiteral("1..5"));
    m_page->focusFilter();
    type(QStringLiteral("eco"));
    letGo();
    QVERIFY(indexOf(ItemId::EcoMode).isValid());
    QVERIFY(!m_page->finishEditing());
    letGo();
    QVERIFY(indexOf(ItemId::Span).isValid()); // brought back, in its editor
    type(QStringLiteral("1.5"));
    QVERIFY(m_page->finishEditing());
    QCOMPARE(m_fixture->wanted(ItemId::Span), std::optional<Value>(15000));
}

void SettingsPageFlow::wrongTextWaitsWhileAnotherSensorIsShown()
{
    SensorFixture other;
    other.open();
    m_page->showItem(ItemId::Span);
    type(QStringLiteral("1..5"));
    m_page->setSession(other.session.get());
    letGo();
    QVERIFY(m_page->finishEditing());
    QCOMPARE(shown(ItemId::Span, SettingsModel::NewValue), QStringLiteral("1.0000"));
    m_page->setSession(m_fixture->session.get());
    QCOMPARE(shown(ItemId::Span, SettingsModel::NewValue), QStringLiteral("1..5"));
    QVERIFY(!m_page->finishEditing());
    press(Qt::Key_Escape);
    QVERIFY(m_page->finishEditing());
    QCOMPARE(shown(ItemId::Span, SettingsModel::NewValue), QStringLiteral("1.0000"));
    m_page->setSession(nullptr);
}

void SettingsPageFlow::theContextMenuSetsTheDefaultAsAnEdit()
{
    m_fixture->changeElsewhere(ItemId::Span, 12345);
    m_page->showItem(ItemId::Span);
    const QPoint at = m_view->visualRect(indexOf(ItemId::Span, SettingsModel::Item)).center();
    Q_EMIT m_view->customContextMenuRequested(at);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu);
    QAction* toDefault = nullptr;
    for (QAction* action : menu->actions()) {
        if (action->text().startsWith(QStringLiteral("Set to default")))
            toDefault = action;
    }
    QVERIFY(toDefault);
    QCOMPARE(toDefault->text(), QStringLiteral("Set to default (1.0000\u00a0×)"));
    toDefault->trigger();
    menu->close();
    QCOMPARE(m_fixture->wanted(ItemId::Span), std::optional<Value>(10000));
    QCOMPARE(m_fixture->sensor().writes(), 0);
}

void SettingsPageFlow::theRowIsCopiedForASpreadsheet()
{
    m_page->showItem(ItemId::HighSetValue);
    m_fixture->session->edit({{ItemId::HighSetValue, 17500}});
    press(Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text(),
             QStringLiteral("31\tHIGH Set Value\t+5.0000\t+1.7500\tmm\t\u22129.5000 … +9.5000\t+5.0000"));
}

void SettingsPageFlow::showItemComesOutFromUnderAFilter()
{
    find<QLineEdit>("filter")->setText(QStringLiteral("communicationSpeed"));
    QVERIFY(!indexOf(ItemId::Tolerance).isValid());
    m_page->showItem(ItemId::Tolerance);
    QCOMPARE(m_view->currentIndex().siblingAtColumn(0), indexOf(ItemId::Tolerance));
    QVERIFY(m_view->viewport()->rect().contains(m_view->visualRect(m_view->currentIndex()).center()));
}

void SettingsPageFlow::aNarrowPageKeepsTheValuesAndDropsRangeAndDefault()
{
    QVERIFY(!m_view->isColumnHidden(SettingsModel::Range));
    QVERIFY(!m_view->isColumnHidden(SettingsModel::Default));
    m_window->resize(760, 500); // 1024 less a dock of 232 and margins
    QTRY_VERIFY(m_view->isColumnHidden(SettingsModel::Range));
    for (const int column : {SettingsModel::Menu, SettingsModel::Item, SettingsModel::InSensor,
                             SettingsModel::NewValue, SettingsModel::Unit}) {
        const QRect cell = m_view->visualRect(indexOf(ItemId::BankSwitching, column));
        QVERIFY2(cell.left() >= 0 && cell.right() < m_view->viewport()->width(),
                 qPrintable(QString::number(column)));
    }
    QVERIFY(m_view->columnWidth(SettingsModel::Item) >= 120);
    QTest::mouseClick(find<QToolButton>("detailsButton"), Qt::LeftButton);
    QTRY_VERIFY(!m_view->isColumnHidden(SettingsModel::Range));
}

void SettingsPageFlow::everythingThatTakesTheFocusHasAName()
{
    int named = 0;
    for (QWidget* widget : m_page->findChildren<QWidget*>()) {
        if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy())
            continue;
        QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
        QVERIFY(interface);
        QVERIFY2(!interface->text(QAccessible::Name).isEmpty(), widget->metaObject()->className());
        ++named;
    }
    QVERIFY(named >= 8); // filter, changed only, four banks, details, tree
    auto* tree = QAccessible::queryAccessibleInterface(m_view);
    QVERIFY(tree && tree->tableInterface());
    int line = 0;
    for (QModelIndex above = m_view->indexAbove(indexOf(ItemId::HighSetValue)); above.isValid();
         above = m_view->indexAbove(above))
        ++line;
    auto* cell = tree->tableInterface()->cellAt(line, SettingsModel::InSensor);
    QVERIFY(cell);
    QCOMPARE(cell->text(QAccessible::Name), QStringLiteral("HIGH Set Value, In the sensor: +5.0000"));
    QVERIFY(!cell->text(QAccessible::Description).isEmpty());
}

void SettingsPageFlow::tabGoesThroughThePageInReadingOrder()
{
    m_page->focusFilter();
    QStringList order;
    for (int step = 0; step < 9; ++step) {
        order += QApplication::focusWidget()->objectName();
        press(Qt::Key_Tab);
    }
    QCOMPARE(order, (QStringList{QStringLiteral("filter"), QStringLiteral("changedOnly"),
                                 QStringLiteral("bank1"), QStringLiteral("bank2"), QStringLiteral("bank3"),
                                 QStringLiteral("bank4"), QStringLiteral("detailsButton"),
                                 QStringLiteral("settingsTree"), QStringLiteral("details")}));
}

void SettingsPageFlow::withoutSensorThePageSaysWhatToDo()
{
    m_page->setSession(nullptr);
    QCOMPARE(m_view->model()->rowCount(), 0);
    QCOMPARE(m_view->emptyText(), QStringLiteral("No sensor is chosen. Connect one to see its settings."));
    QVERIFY(!find<QPushButton>("bank1")->isChecked());
    m_fixture->session.reset();
    m_page->showItem(ItemId::Span); // nothing to show, nothing to fall over
    QVERIFY(m_page->finishEditing());
}

QTEST_MAIN(SettingsPageFlow)
#include "flow_settings_page.moc"
