#include "choice_editor.h"
#include "editor_message.h"
#include "item_delegate.h"
#include "number_editor.h"
#include "octets_editor.h"
#include "page_fixture.h"
#include "settings_view.h"

#include <QClipboard>
#include <QHeaderView>
#include <QLineEdit>
#include <QVBoxLayout>

using namespace lds;
using namespace lds::ui;

/// Editors where they live: in the rows of the tree, driven by keys.
class SettingsEditorsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void typingReplacesTheValueAndEnterMovesDown();
    void f2KeepsTheValueAndSelectsIt();
    void escapeAbandons();
    void wrongTextStaysOpenAndSaysWhatIsWrong_data();
    void wrongTextStaysOpenAndSaysWhatIsWrong();
    void wrongTextSurvivesLosingTheFocus();
    void wrongTextSurvivesItsRowGoingAway();
    void putRightItIsCommitted();
    void roundingDownIsSaidBeforeItIsWritten();
    void aBrokenRuleIsSaidAndDoesNotKeepTheValueOut();
    void stepKeysAreExactAndStopAtTheLimits();
    void pageKeysStepByTenAndAHundred();
    void anOpenEditorSurvivesValuesFromTheSensor();
    void tabEditsTheNextEditableRow();
    void choicesAreThoseOfTheType();
    void choosingWithTheKeysCommits();
    void octetsAreTypedThrough();
    void aWholeAddressCanBePasted();
    void aWrongOctetSaysWhichOne();
    void deleteRevertsARow();
    void aSecondEditorWaitsForTheWrongOne();

private:
    void select(ItemId item) const { m_view->setCurrentIndex(m_model->indexOf(item)); }
    template <typename Editor>
    Editor* openWith(ItemId item, Qt::Key key = Qt::Key_F2) const
    {
        select(item);
        QTest::keyClick(m_view.get(), key);
        return m_view->viewport()->findChild<Editor*>();
    }
    template <typename Editor>
    Editor* editor() const
    {
        return m_view->viewport()->findChild<Editor*>();
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
    ItemId currentItem() const { return m_model->row(m_view->currentIndex())->first()->id; }

    std::unique_ptr<SensorFixture> m_fixture;
    std::unique_ptr<SettingsModel> m_model;
    std::unique_ptr<ItemDelegate> m_delegate;
    std::unique_ptr<QWidget> m_window;
    std::unique_ptr<SettingsView> m_view;
};

void SettingsEditorsTest::initTestCase() { Theme::instance().apply(*qApp, ThemeMode::Light); }

void SettingsEditorsTest::init()
{
    m_fixture =
        std::make_unique<SensorFixture>(catalog::SensorModel::HlG205); // resolution 1 µm, three decimals
    m_fixture->open();
    m_model = std::make_unique<SettingsModel>();
    m_model->setSession(m_fixture->session.get());
    m_delegate = std::make_unique<ItemDelegate>(*m_model, nullptr);
    m_window = std::make_unique<QWidget>();
    m_view = std::make_unique<SettingsView>(m_window.get());
    m_view->setModel(m_model.get());
    m_view->setDelegate(m_delegate.get());
    m_view->expandAll();
    m_view->resize(900, 700);
    m_window->resize(900, 700);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_view->setFocus();
}

void SettingsEditorsTest::cleanup()
{
    m_view.reset();
    m_window.reset();
    m_delegate.reset();
    m_model.reset();
    m_fixture.reset();
}

void SettingsEditorsTest::typingReplacesTheValueAndEnterMovesDown()
{
    select(ItemId::HighSetValue);
    type(QStringLiteral("1.75"));
    QCOMPARE(editor<NumberEditor>()->text(), QStringLiteral("1.75"));
    press(Qt::Key_Return);
    letGo();
    QCOMPARE(m_fixture->wanted(ItemId::HighSetValue), std::optional<Value>(17500));
    QVERIFY(!editor<NumberEditor>());
    QCOMPARE(currentItem(), ItemId::LowSetValue);
    QVERIFY(m_view->hasFocus());
}

void SettingsEditorsTest::f2KeepsTheValueAndSelectsIt()
{
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    QVERIFY(open);
    QCOMPARE(open->text(), QStringLiteral("+10.000"));
    QCOMPARE(open->findChild<QLineEdit*>()->selectedText(), QStringLiteral("+10.000"));
    press(Qt::Key_Return);
    QVERIFY(!m_fixture->wanted(ItemId::HighSetValue)); // nothing was changed
}

void SettingsEditorsTest::escapeAbandons()
{
    QVERIFY(openWith<NumberEditor>(ItemId::HighSetValue));
    type(QStringLiteral("oops"));
    press(Qt::Key_Escape);
    letGo();
    QVERIFY(!editor<NumberEditor>());
    QVERIFY(!m_model->hasWrongInput());
    QVERIFY(m_fixture->session->pending().isEmpty());
    QCOMPARE(currentItem(), ItemId::HighSetValue);
    QVERIFY(m_view->hasFocus());
}

void SettingsEditorsTest::wrongTextStaysOpenAndSaysWhatIsWrong_data()
{
    QTest::addColumn<QString>("text");
    QTest::newRow("no number") << "1.7x";
    QTest::newRow("two points") << "1.2.3";
    QTest::newRow("out of range") << "95.001";
    QTest::newRow("too fine for the wire") << "1.00001";
    QTest::newRow("nothing but a sign") << "-";
}

void SettingsEditorsTest::wrongTextStaysOpenAndSaysWhatIsWrong()
{
    QFETCH(QString, text);
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    type(text);
    const QString said = open->message().text();
    QVERIFY(!said.isEmpty());
    QCOMPARE(open->message().kind(), EditorMessage::Kind::Error);
    QVERIFY(open->message().isVisible());
    QCOMPARE(open->accessibleDescription(), said);
    press(Qt::Key_Return);
    letGo();
    QCOMPARE(editor<NumberEditor>(), open); // still there, with what was typed
    QCOMPARE(open->text(), text);
    QVERIFY(open->hasFocus());
    QVERIFY(m_fixture->session->pending().isEmpty());
    QCOMPARE(currentItem(), ItemId::HighSetValue);
}

void SettingsEditorsTest::wrongTextSurvivesLosingTheFocus()
{
    // The view closes the editor of the current cell by itself when another becomes current.
    m_view->setCurrentIndex(m_model->indexOf(ItemId::HighSetValue, SettingsModel::NewValue));
    QTest::keyClick(m_view.get(), Qt::Key_F2);
    auto* open = editor<NumberEditor>();
    type(QStringLiteral("abc"));
    const QRect elsewhere = m_view->visualRect(m_model->indexOf(ItemId::Tolerance, SettingsModel::Item));
    QTest::mouseClick(m_view->viewport(), Qt::LeftButton, {}, elsewhere.center());
    letGo();
    QCOMPARE(editor<NumberEditor>(), open);
    QCOMPARE(open->text(), QStringLiteral("abc"));
    QVERIFY(statesOf(*m_model, ItemId::HighSetValue).testFlag(SettingsModel::WrongText));
}

void SettingsEditorsTest::wrongTextSurvivesItsRowGoingAway()
{
    QVERIFY(openWith<NumberEditor>(ItemId::HighSetValue));
    type(QStringLiteral("abc"));
    m_view->releaseEditing();
    m_model->setSession(nullptr);
    letGo();
    QVERIFY(!editor<NumberEditor>());
    m_model->setSession(m_fixture->session.get());
    m_view->expandAll();
    QCOMPARE(cell(*m_model, ItemId::HighSetValue, SettingsModel::NewValue), QStringLiteral("abc"));
    auto* again = openWith<NumberEditor>(ItemId::HighSetValue);
    QCOMPARE(again->text(), QStringLiteral("abc"));
    QVERIFY(!again->error().isEmpty());
}

void SettingsEditorsTest::putRightItIsCommitted()
{
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    type(QStringLiteral("1.5x"));
    press(Qt::Key_Return);
    open->findChild<QLineEdit*>()->end(false);
    press(Qt::Key_Backspace);
    QVERIFY(open->message().text().isEmpty());
    press(Qt::Key_Return);
    letGo();
    QVERIFY(!editor<NumberEditor>());
    QVERIFY(!m_model->hasWrongInput());
    QCOMPARE(m_fixture->wanted(ItemId::HighSetValue), std::optional<Value>(15000));
}

void SettingsEditorsTest::roundingDownIsSaidBeforeItIsWritten()
{
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    type(QStringLiteral("1.2345")); // this type keeps 1 µm (§4.4.1)
    QCOMPARE(open->message().kind(), EditorMessage::Kind::Note);
    QVERIFY2(open->message().text().contains(QStringLiteral("+1.234\u00a0mm")),
             qPrintable(open->message().text()));
    press(Qt::Key_Return);
    QCOMPARE(m_fixture->wanted(ItemId::HighSetValue), std::optional<Value>(12340));
    QCOMPARE(cell(*m_model, ItemId::HighSetValue, SettingsModel::NewValue), QStringLiteral("+1.234"));
}

void SettingsEditorsTest::aBrokenRuleIsSaidAndDoesNotKeepTheValueOut()
{
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    type(QStringLiteral("-20")); // below LOW, −10.000; LOW may be the next edit
    QCOMPARE(open->message().kind(), EditorMessage::Kind::Warning);
    press(Qt::Key_Return);
    QCOMPARE(m_fixture->wanted(ItemId::HighSetValue), std::optional<Value>(-200000));
    QVERIFY(statesOf(*m_model, ItemId::HighSetValue).testFlag(SettingsModel::Problem));
}

void SettingsEditorsTest::stepKeysAreExactAndStopAtTheLimits()
{
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    press(Qt::Key_Up);
    QCOMPARE(open->text(), QStringLiteral("+10.001"));
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    QCOMPARE(open->text(), QStringLiteral("+9.999"));
    open->findChild<QLineEdit*>()->selectAll();
    type(QStringLiteral("94.9995"));
    press(Qt::Key_Up);
    QCOMPARE(open->text(), QStringLiteral("+95.000"));
    press(Qt::Key_Up);
    QCOMPARE(open->text(), QStringLiteral("+95.000"));
}

void SettingsEditorsTest::pageKeysStepByTenAndAHundred()
{
    auto* open = openWith<NumberEditor>(ItemId::Hysteresis);
    QCOMPARE(open->text(), QStringLiteral("0.020"));
    press(Qt::Key_PageUp);
    QCOMPARE(open->text(), QStringLiteral("0.030"));
    press(Qt::Key_PageUp, Qt::ShiftModifier);
    QCOMPARE(open->text(), QStringLiteral("0.130"));
    press(Qt::Key_PageDown, Qt::ControlModifier);
    press(Qt::Key_PageDown, Qt::ControlModifier);
    QCOMPARE(open->text(), QStringLiteral("0.000")); // not below the minimum
}

void SettingsEditorsTest::anOpenEditorSurvivesValuesFromTheSensor()
{
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    type(QStringLiteral("1.7"));
    m_fixture->changeElsewhere(ItemId::HighSetValue, 30000);
    m_fixture->changeElsewhere(ItemId::Span, 20000);
    QCOMPARE(editor<NumberEditor>(), open);
    QCOMPARE(open->text(), QStringLiteral("1.7"));
    QVERIFY(open->hasFocus());
    QCOMPARE(cell(*m_model, ItemId::HighSetValue, SettingsModel::InSensor), QStringLiteral("+3.000"));
    press(Qt::Key_Return);
    QCOMPARE(m_fixture->wanted(ItemId::HighSetValue), std::optional<Value>(17000));
}

void SettingsEditorsTest::tabEditsTheNextEditableRow()
{
    QVERIFY(openWith<NumberEditor>(ItemId::Offset)); // 27; 3 is a heading, 31 comes next
    type(QStringLiteral("1"));
    press(Qt::Key_Tab);
    letGo();
    QCOMPARE(m_fixture->wanted(ItemId::Offset), std::optional<Value>(10000));
    QCOMPARE(currentItem(), ItemId::HighSetValue);
    QVERIFY(editor<NumberEditor>());
    press(Qt::Key_Backtab);
    letGo();
    QCOMPARE(currentItem(), ItemId::Offset);
}

void SettingsEditorsTest::choicesAreThoseOfTheType()
{
    auto* open = openWith<ChoiceEditor>(ItemId::DisplayDigit);
    QVERIFY(open);
    QCOMPARE(open->count(), 4); // 50 mm: three digits to none (§4.8.1)
    QCOMPARE(open->findData(0), -1);
    QCOMPARE(open->currentData().toInt(), 1);
}

void SettingsEditorsTest::choosingWithTheKeysCommits()
{
    auto* open = openWith<ChoiceEditor>(ItemId::HoldMode);
    QVERIFY(open);
    QTRY_VERIFY(open->view()->isVisible());
    QTest::keyClick(open->view(), Qt::Key_Down);
    QTest::keyClick(open->view(), Qt::Key_Return);
    letGo();
    QCOMPARE(m_fixture->wanted(ItemId::HoldMode), std::optional<Value>(1));
    QVERIFY(!editor<ChoiceEditor>());
    QVERIFY(m_view->hasFocus());
}

void SettingsEditorsTest::octetsAreTypedThrough()
{
    select(ItemId::IpAddress1stOctet);
    type(QStringLiteral("10.20.3.44"));
    auto* open = editor<OctetsEditor>();
    QVERIFY(open);
    QCOMPARE(open->text(), QStringLiteral("10.20.3.44"));
    press(Qt::Key_Return);
    letGo();
    QVERIFY(!editor<OctetsEditor>());
    QCOMPARE(m_fixture->wanted(ItemId::IpAddress1stOctet), std::optional<Value>(10));
    QCOMPARE(m_fixture->wanted(ItemId::IpAddress4thOctet), std::optional<Value>(44));
    QCOMPARE(m_fixture->session->pending().count(), 1);
    QVERIFY(m_view->hasFocus());
}

void SettingsEditorsTest::aWholeAddressCanBePasted()
{
    QApplication::clipboard()->setText(QStringLiteral(" 172.16.0.9/24\n"));
    QVERIFY(openWith<OctetsEditor>(ItemId::DefaultGateway1stOctet));
    press(Qt::Key_Right); // out of the selection, into the second field
    press(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(editor<OctetsEditor>()->text(), QStringLiteral("172.16.0.9"));
    press(Qt::Key_Return);
    QCOMPARE(m_fixture->wanted(ItemId::DefaultGateway2ndOctet), std::optional<Value>(16));
}

void SettingsEditorsTest::aWrongOctetSaysWhichOne()
{
    auto* open = openWith<OctetsEditor>(ItemId::IpAddress1stOctet);
    type(QStringLiteral("192.300"));
    QCOMPARE(open->message().kind(), EditorMessage::Kind::Error);
    QVERIFY(open->message().text().contains(QStringLiteral("300")));
    QVERIFY(open->message().text().contains(QStringLiteral("2nd octet")));
    press(Qt::Key_Return);
    letGo();
    QCOMPARE(editor<OctetsEditor>(), open);
    QVERIFY(open->field(1)->hasFocus());
    QVERIFY(m_fixture->session->pending().isEmpty());
}

void SettingsEditorsTest::deleteRevertsARow()
{
    QSignalSpy reverted(m_view.get(), &SettingsView::revertRequested);
    select(ItemId::Span);
    QTest::keyClick(m_view.get(), Qt::Key_Delete);
    QCOMPARE(reverted.size(), 1);
    QVERIFY(!editor<NumberEditor>());
}

void SettingsEditorsTest::aSecondEditorWaitsForTheWrongOne()
{
    auto* open = openWith<NumberEditor>(ItemId::HighSetValue);
    type(QStringLiteral("abc"));
    m_view->setFocus();
    select(ItemId::Span);
    QTest::keyClick(m_view.get(), Qt::Key_F2);
    QCOMPARE(m_view->viewport()->findChildren<NumberEditor*>().size(), 1);
    QVERIFY(open->hasFocus());
    QCOMPARE(open->text(), QStringLiteral("abc"));
}

QTEST_MAIN(SettingsEditorsTest)
#include "tst_settings_editors.moc"
