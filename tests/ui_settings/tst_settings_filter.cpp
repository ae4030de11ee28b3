#include "page_fixture.h"
#include "settings_filter.h"

using namespace lds;
using namespace lds::ui;

class SettingsFilterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void findsByNumberNameKeyValueAndHelp_data();
    void findsByNumberNameKeyValueAndHelp();
    void aMenuNumberFindsWhatStandsBelowIt();
    void aNumberThatIsNoMenuIsLookedForInValues();
    void headingsStayAboveWhatIsFound();
    void everyWordMustMatch();
    void changedOnlyShowsEditsAndWrongText();
    void nothingFoundIsEmpty();
    void aPinnedRowStays();
    void aRevertedRowLeavesChangedOnly();

private:
    bool shows(ItemId item) const { return m_filter->mapFromSource(m_model->indexOf(item)).isValid(); }
    bool showsMenu(int number) const
    {
        return m_filter->mapFromSource(m_model->indexOf(m_model->tree()->findMenu(number))).isValid();
    }

    std::unique_ptr<SensorFixture> m_fixture;
    std::unique_ptr<SettingsModel> m_model;
    std::unique_ptr<SettingsFilter> m_filter;
};

void SettingsFilterTest::init()
{
    m_fixture = std::make_unique<SensorFixture>();
    m_fixture->open();
    m_model = std::make_unique<SettingsModel>();
    m_filter = std::make_unique<SettingsFilter>(*m_model);
    m_model->setSession(m_fixture->session.get());
}

void SettingsFilterTest::cleanup()
{
    m_filter.reset();
    m_model.reset();
    m_fixture.reset();
}

void SettingsFilterTest::findsByNumberNameKeyValueAndHelp_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<ItemId>("found");
    QTest::addColumn<ItemId>("hidden");
    QTest::newRow("number") << "32" << ItemId::LowSetValue << ItemId::HighSetValue;
    QTest::newRow("name") << "hysteresis" << ItemId::Hysteresis << ItemId::Span;
    QTest::newRow("other case") << "HYSTERESIS" << ItemId::Hysteresis << ItemId::Span;
    QTest::newRow("the register table's name")
        << "Inversion of" << ItemId::InversionOfMeasuredValue << ItemId::Span;
    QTest::newRow("key") << "outputDelayTimerSetting" << ItemId::OutputDelayTimerSetting << ItemId::Span;
    QTest::newRow("value") << "normal mode" << ItemId::HoldMode << ItemId::Span;
    QTest::newRow("value with a typed hyphen") << "-5.0000" << ItemId::LowSetValue << ItemId::HighSetValue;
    QTest::newRow("help") << "chattering" << ItemId::Hysteresis << ItemId::Span;
    QTest::newRow("full-width digits")
        << QString::fromUtf8("３２") << ItemId::LowSetValue << ItemId::HighSetValue;
}

void SettingsFilterTest::findsByNumberNameKeyValueAndHelp()
{
    QFETCH(QString, text);
    QFETCH(ItemId, found);
    QFETCH(ItemId, hidden);
    m_filter->setText(text);
    QVERIFY(shows(found));
    QVERIFY(!shows(hidden));
}

void SettingsFilterTest::aMenuNumberFindsWhatStandsBelowIt()
{
    m_filter->setText(QStringLiteral("42"));
    QVERIFY(showsMenu(42));
    QVERIFY(shows(ItemId::OutputDelayTimerSelection));
    QVERIFY(shows(ItemId::OutputDelayTimerSetting));
    QVERIFY(showsMenu(4)); // above
    QVERIFY(!showsMenu(24));
    m_filter->setText(QStringLiteral("3"));
    QVERIFY(shows(ItemId::Tolerance));
    QVERIFY(!shows(ItemId::BrightnessTuning));
}

void SettingsFilterTest::aNumberThatIsNoMenuIsLookedForInValues()
{
    m_filter->setText(QStringLiteral("512"));
    QVERIFY(shows(ItemId::AverageTimes));
    QVERIFY(!shows(ItemId::SamplingFrequency));
    m_filter->setText(QStringLiteral("49152"));
    QVERIFY(shows(ItemId::PortTool));
}

void SettingsFilterTest::headingsStayAboveWhatIsFound()
{
    m_filter->setText(QStringLiteral("outputDelayTimerSetting"));
    const QModelIndex row = m_filter->mapFromSource(m_model->indexOf(ItemId::OutputDelayTimerSetting));
    QVERIFY(row.isValid());
    QCOMPARE(row.parent().data().toString(), QStringLiteral("42"));
    QCOMPARE(row.parent().parent().data().toString(), QStringLiteral("4"));
    QCOMPARE(m_filter->rowCount(), 1);
}

void SettingsFilterTest::everyWordMustMatch()
{
    m_filter->setText(QStringLiteral("judgment hysteresis"));
    QVERIFY(shows(ItemId::Hysteresis)); // "Judgment" is its heading
    m_filter->setText(QStringLiteral("ethernet hysteresis"));
    QVERIFY(!shows(ItemId::Hysteresis));
}

void SettingsFilterTest::changedOnlyShowsEditsAndWrongText()
{
    m_filter->setChangedOnly(true);
    QCOMPARE(m_filter->rowCount(), 0);
    m_fixture->session->edit({{ItemId::Span, 20000}});
    QVERIFY(shows(ItemId::Span));
    QVERIFY(showsMenu(2));
    QVERIFY(!shows(ItemId::Offset));
    m_model->keepWrongInput(*m_model->tree()->find(ItemId::Tolerance),
                            {QStringLiteral("x"), QStringLiteral("y")});
    QVERIFY(shows(ItemId::Tolerance));
    m_filter->setText(QStringLiteral("tolerance"));
    QVERIFY(!shows(ItemId::Span));
    QVERIFY(shows(ItemId::Tolerance));
}

void SettingsFilterTest::nothingFoundIsEmpty()
{
    m_filter->setText(QStringLiteral("no such thing"));
    QCOMPARE(m_filter->rowCount(), 0);
    m_filter->setText({});
    QCOMPARE(m_filter->rowCount(), m_model->rowCount());
}

void SettingsFilterTest::aPinnedRowStays()
{
    m_filter->setText(QStringLiteral("span"));
    m_filter->setPinned(m_model->indexOf(ItemId::Offset, SettingsModel::NewValue));
    QVERIFY(shows(ItemId::Offset));
    m_filter->setPinned({});
    m_filter->setText(QStringLiteral("eco"));
    QVERIFY(!shows(ItemId::Offset));
}

void SettingsFilterTest::aRevertedRowLeavesChangedOnly()
{
    m_fixture->session->edit({{ItemId::Span, 20000}});
    m_filter->setChangedOnly(true);
    QVERIFY(shows(ItemId::Span));
    m_fixture->session->revert({ItemId::Span});
    QVERIFY(!shows(ItemId::Span));
    QCOMPARE(m_filter->rowCount(), 0);
}

QTEST_GUILESS_MAIN(SettingsFilterTest)
#include "tst_settings_filter.moc"
